#!/bin/sh
# SPDX-License-Identifier: MIT OR Apache-2.0
#
# Compiles the headers in every language mode, checks layouts and values, and
# compiles the example and test programs. With the folder of our libraries as
# argument, links all programs and runs them as well.
#
#     tests/c/headers.sh [LIBRARY_DIR]
#
# CC and CXX choose the compilers. Exit code 0 when everything holds.
set -u

root=$(cd "$(dirname "$0")/../.." && pwd)
library=${1:-}
cc=${CC:-cc}
cxx=${CXX:-c++}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0
failed=0

# check NAME COMMAND...: runs quietly, counts, shows the output of failures.
check() {
    what=$1
    shift
    if "$@" >"$work/output" 2>&1; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        echo "failed: $what"
        sed 's/^/    /' "$work/output"
    fi
}

strict="-Wall -Wextra -Werror -pedantic -I$root/include"
headers="3dfx fxdll glidesys sst1vid glide glideutl gump"

# Each header alone and twice, all in both orders, types without prototypes.
{
    for h in $headers; do
        printf '#include <%s.h>\n#include <%s.h>\nint used_%s;\n' "$h" "$h" "$h" >"$work/$h.c"
    done
    printf '#include <%s.h>\n' $headers >"$work/forwards.c"
    printf '#include <%s.h>\n' gump glideutl glide sst1vid glidesys fxdll 3dfx >"$work/backwards.c"
    printf '#define FX_GLIDE_NO_FUNC_PROTO\n#include <glide.h>\nGrVertex used_vertex;\n' >"$work/types.c"
    printf 'int used_forwards;\n' >>"$work/forwards.c"
    printf 'int used_backwards;\n' >>"$work/backwards.c"
}
printf '#include <render_client.h>\n#include <render_client.h>\nint used_client;\n' \
    >"$work/render_client.c"
for file in $headers forwards backwards types render_client; do
    for standard in c89 c99 c11 c17; do
        check "$file.h as $standard" "$cc" -std=$standard $strict -fsyntax-only "$work/$file.c"
    done
    if command -v "$cxx" >/dev/null; then
        check "$file.h as c++17" "$cxx" -x c++ -std=c++17 $strict -fsyntax-only "$work/$file.c"
    fi
done

# Layouts and values: as assertions for both pointer sizes, then run.
for test in layout values; do
    source=$root/tests/c/$test.c
    check "$test.c, compile time" "$cc" -std=c89 $strict -DCHECK_STATIC -fsyntax-only "$source"
    if "$cc" -m32 -fsyntax-only "$work/types.c" -I"$root/include" 2>/dev/null; then
        check "$test.c, 32 bits" "$cc" -m32 -std=c89 $strict -DCHECK_STATIC -fsyntax-only "$source"
    fi
    check "$test.c" "$cc" -std=c89 $strict "$source" -o "$work/$test"
    check "$test" "$work/$test"
done

# This header includes those of the C library, which may be there for one size only.
check "raw_values.c, compile time" "$cc" -std=c89 $strict -DCHECK_STATIC -fsyntax-only \
    "$root/tests/c/raw_values.c"

raw_programs="$root/tests/c/raw_values.c $root/tests/c/raw_calls.c $root/examples/raw/*.c"
programs="$root/tests/c/bad_input.c $root/tests/c/bad_values.c $root/examples/glide/*.c"
if [ -z "$library" ]; then
    for source in $programs $raw_programs; do
        check "$(basename "$source")" "$cc" -std=c99 $strict -fsyntax-only "$source"
    done
else
    library=$(cd "$library" && pwd) || exit 1
    for source in $programs; do
        name=$(basename "$source" .c)
        check "$name.c" "$cc" -std=c99 -O1 $strict "$source" -o "$work/$name" \
            -L"$library" -lglide2x -lm
    done
    for source in $raw_programs; do
        name=$(basename "$source" .c)
        check "$name.c" "$cc" -std=c99 -O1 $strict "$source" -o "$work/$name" \
            -L"$library" -lrender_client -lm
    done
    LD_LIBRARY_PATH=$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
    export LD_LIBRARY_PATH
    for mode in 0 1; do
        check "bad_input, FILLRATE_CHECK=$mode" env FILLRATE_CHECK=$mode "$work/bad_input"
        check "bad_values, FILLRATE_CHECK=$mode" env FILLRATE_CHECK=$mode "$work/bad_values"
    done
    for source in $raw_programs; do
        name=$(basename "$source" .c)
        check "$name" "$work/$name"
    done
    for source in "$root"/examples/glide/*.c; do
        name=$(basename "$source" .c)
        check "$name -n 2" "$work/$name" -n 2
        # A program that breaks no rule says nothing in checking mode.
        check "$name, checked" env FILLRATE_CHECK=1 "$work/$name" -n 1
    done
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
