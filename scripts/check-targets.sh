#!/usr/bin/env bash
# Compiles the lanes crate for AArch64 and WebAssembly and runs its tests there
# where an emulator is installed. Says what it did for each target, and exits
# with 1 when something was compiled or run and failed.
#
# The standard library of a target comes from rustup (`rustup target add ...`)
# or is built from its sources, if a toolchain has them: rustup's `rust-src`,
# or Debian's rustc-web, cargo-web and rust-web-src. CHECK_CARGO and
# CHECK_RUSTC choose another toolchain than the first one found.
set -u
cd "$(dirname "$0")/.." || exit 1

failed=0
say() { printf '%-32s %s\n' "$1" "$2"; }

# The toolchains to try, a pair of cargo and rustc each.
toolchains() {
    if [ -n "${CHECK_CARGO:-}" ]; then
        echo "$CHECK_CARGO ${CHECK_RUSTC:-rustc}"
    else
        echo "cargo rustc"
        [ -x /usr/bin/cargo ] && [ -x /usr/bin/rustc ] && echo "/usr/bin/cargo /usr/bin/rustc"
    fi
}

# Sets cargo, rustc and build_std for target $1; fails where no toolchain can.
find_toolchain() {
    local sysroot
    while read -r cargo rustc; do
        sysroot=$("$rustc" --print sysroot 2>/dev/null) || continue
        if compgen -G "$sysroot/lib/rustlib/$1/lib/libcore-*" >/dev/null; then
            build_std=()
            return 0
        elif [ -f "$sysroot/lib/rustlib/src/rust/library/core/Cargo.toml" ]; then
            build_std=(-Z build-std=std,panic_abort,test)
            return 0
        fi
    done < <(toolchains)
    return 1
}

# check TARGET RUSTFLAGS LINKER RUNNER...: compiles for the target; links and
# runs the tests where the linker and the runner exist.
check() {
    local target=$1 flags=$2 linker=$3
    shift 3
    local name="$target${flags##*=}" upper=${target//-/_}
    upper=${upper^^}
    if ! find_toolchain "$target"; then
        say "$name" "NOT CHECKED: no standard library and no sources of it"
        return
    fi
    local run=(env "RUSTC=$rustc" "RUSTFLAGS=$flags"
        "CARGO_TARGET_${upper}_LINKER=$linker" "CARGO_TARGET_${upper}_RUNNER=$*")
    [ ${#build_std[@]} -gt 0 ] && run+=(RUSTC_BOOTSTRAP=1)
    local command=check
    if [ "$(uname -m)-unknown-linux-gnu" = "$target" ]; then
        run=(env "RUSTC=$rustc") command=test
    elif command -v "$linker" >/dev/null && command -v "$1" >/dev/null; then
        command=test
    fi
    if "${run[@]}" "$cargo" "$command" --quiet --lib -p fillrate-simd --target "$target" \
        ${build_std[@]+"${build_std[@]}"}; then
        case $command in
        test) say "$name" "ok: compiled, all tests passed" ;;
        *) say "$name" "ok: compiled; tests NOT RUN ($linker or $1 is missing)" ;;
        esac
    else
        say "$name" "FAILED"
        failed=1
    fi
}

check aarch64-unknown-linux-gnu "" aarch64-linux-gnu-gcc qemu-aarch64 -L /usr/aarch64-linux-gnu
wasm_linker=$(command -v wasm-ld || command -v wasm-ld-19 || echo rust-lld)
wasm_runner=(node --stack-trace-limit=60 "$PWD/scripts/run-wasm-tests.mjs")
check wasm32-unknown-unknown "-C target-feature=+simd128" "$wasm_linker" "${wasm_runner[@]}"
check wasm32-unknown-unknown "" "$wasm_linker" "${wasm_runner[@]}"
exit $failed
