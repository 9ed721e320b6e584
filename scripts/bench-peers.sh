#!/usr/bin/env bash
# Measures W1 to W9 by turns with other renderers, and prints one table.
#
#   scripts/bench-peers.sh [-n ROUNDS] [-s WxH] [-t THREADS] [-o DIR] [-w PREFIX]... PEERS
#
# PEERS is a folder with programs that draw the same scenes and print the lines
# which `fillrate bench --vs` reads: glbench.c (OpenGL through EGL), and
# vkbench.c with vk_*.glsl (Vulkan); each takes LABEL WxH FORMAT and prefixes of
# workloads. What cannot be built, or finds no driver, is said and left out.
# They are run on Mesa's llvmpipe and lavapipe with as many threads as ours,
# and on the Vulkan driver that SWIFTSHADER names (an icd.json), if set.
#
# A round draws each workload once by every renderer, one after the other, so
# that all meet the same machine. DIR (default target/bench-peers) keeps
# ours.jsonl, peers.csv and table.md.
set -euo pipefail
cd "$(dirname "$0")/.."

rounds=7 size=640x480 threads=2 out=target/bench-peers workloads=()
usage() { sed -n '2,/^set/{s/^# \{0,1\}//;/^set/!p}' "$0" >&2; exit 2; }
while getopts n:s:t:o:w: option; do
    case $option in
        n) rounds=$OPTARG ;;
        s) size=$OPTARG ;;
        t) threads=$OPTARG ;;
        o) out=$OPTARG ;;
        w) workloads+=("$OPTARG") ;;
        *) usage ;;
    esac
done
shift $((OPTIND - 1))
[ $# -eq 1 ] && [ -d "$1" ] || usage
peers=$(cd "$1" && pwd)
[ ${#workloads[@]} -gt 0 ] || workloads=(W1 W2 W3 W4 W5 W6a W6b W7 W8 W9)

mkdir -p "$out/build"
out=$(cd "$out" && pwd)
cargo build --release --quiet -p fillrate-cli
: >"$out/ours.jsonl"
: >"$out/peers.csv"
: >"$out/log"

# The first Vulkan driver description that matches.
driver() { ls /usr/share/vulkan/icd.d/$1 2>/dev/null | head -1; }

# Names of the renderers there are; `peer NAME PREFIX` runs one.
available=()
missing() { echo "left out: $*" >&2; }

if cc -O2 -march=native "$peers/glbench.c" -o "$out/build/glbench" -lEGL -lGL -lm 2>>"$out/log"; then
    available+=(llvmpipe)
else
    missing "llvmpipe: glbench.c is not built, see $out/log"
fi

build_vulkan() {
    local stage
    : >"$out/build/spv.h"
    for stage in vert vert_flat vert_col vert_tex frag_flat frag_col frag_tex frag_multi; do
        glslangValidator -V -S "${stage%%_*}" --vn "vk_$stage" -o "$out/build/$stage.h" \
            "$peers/vk_$stage.glsl" || return 1
        cat "$out/build/$stage.h" >>"$out/build/spv.h"
    done
    cc -O2 -march=native -I"$out/build" "$peers/vkbench.c" -o "$out/build/vkbench" -lvulkan -lm
}
lavapipe=$(driver 'lvp_icd*.json')
if build_vulkan >>"$out/log" 2>&1; then
    if [ -n "$lavapipe" ]; then available+=(lavapipe); else missing "lavapipe: no driver"; fi
    if [ -n "${SWIFTSHADER:-}" ]; then available+=(swiftshader); fi
else
    missing "Vulkan: vkbench.c is not built, see $out/log"
fi

peer() {
    local icd
    case $1 in
        llvmpipe)
            LP_NUM_THREADS=$threads "$out/build/glbench" "llvmpipe-LP$threads" "$size" 565 "$2"
            ;;
        *)
            icd=$lavapipe
            [ "$1" = swiftshader ] && icd=$SWIFTSHADER
            LP_NUM_THREADS=$threads VK_DRIVER_FILES=$icd VK_ICD_FILENAMES=$icd \
                "$out/build/vkbench" "$1-$threads" "$size" 565 "$2"
            ;;
    esac
}

for round in $(seq "$rounds"); do
    for workload in "${workloads[@]}"; do
        echo "round $round: $workload" >&2
        target/release/fillrate bench --json --runs 7 --threads "$threads" --size "$size" \
            --only "$workload" >>"$out/ours.jsonl"
        for name in "${available[@]}"; do
            peer "$name" "$workload" >>"$out/peers.csv" 2>>"$out/log" ||
                missing "$name $workload: failed, see $out/log"
        done
    done
done
[ -s "$out/peers.csv" ] || { echo "no other renderer gave figures" >&2; exit 1; }
target/release/fillrate bench --vs "$out/peers.csv" --measured "$out/ours.jsonl" | tee "$out/table.md"
