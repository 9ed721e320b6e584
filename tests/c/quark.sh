#!/bin/sh
# SPDX-License-Identifier: MIT OR Apache-2.0
#
# Compiles quark.h in every mode of C++, and the programs that check it. With
# the folder of our libraries as argument, links and runs them as well.
#
#     tests/c/quark.sh [LIBRARY_DIR]
#
# CXX chooses the compiler. Exit code 0 when everything holds.
set -u

root=$(cd "$(dirname "$0")/../.." && pwd)
library=${1:-}
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
printf '#include <quark.h>\n#include <quark.h>\nint used;\n' >"$work/twice.cpp"
for standard in c++98 c++11 c++14 c++17 c++20; do
    flags="-std=$standard"
    check "quark.h as $standard" "$cxx" $flags $strict -fsyntax-only "$work/twice.cpp"
done
check "layouts, 64 bits" "$cxx" -std=c++17 $strict -fsyntax-only "$root/tests/c/quark_names.cpp"
if "$cxx" -m32 -fsyntax-only -I"$root/include" "$work/twice.cpp" 2>/dev/null; then
    check "layouts, 32 bits" "$cxx" -m32 -std=c++17 $strict -fsyntax-only \
        "$root/tests/c/quark_names.cpp"
fi
for source in "$root"/examples/quark/*.cpp; do
    check "$(basename "$source") as c++11" "$cxx" -std=c++11 $strict -fsyntax-only "$source"
done

if [ -n "$library" ]; then
    library=$(cd "$library" && pwd) || exit 1
    LD_LIBRARY_PATH=$library${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
    export LD_LIBRARY_PATH
    for name in quark_names quark_document quark_bad_input; do
        check "$name.cpp" "$cxx" -std=c++17 -O1 $strict "$root/tests/c/$name.cpp" \
            -o "$work/$name" -L"$library" -lquark3d
        check "$name" "$work/$name"
        check "$name, recorded" env FILLRATE_TRACE="$work/trace" "$work/$name"
    done
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
