#!/bin/sh
# Downloads OpenArena's levels and textures from Debian and unpacks them, for
# `fillrate-level --data FOLDER`. Nothing is installed. The game's data is
# licensed under GPL-2 or later: its copyright file is kept beside it.
#
#     scripts/fetch-level.sh [FOLDER]        default: level-data
#
# Needs Debian's apt-get and dpkg-deb.
set -eu

folder=${1:-level-data}
packages="openarena-data openarena-085-data openarena-081-maps openarena-081-textures"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cd "$work"
# shellcheck disable=SC2086
apt-get download $packages
for package in *.deb; do
    dpkg-deb -x "$package" files
done
cp files/usr/share/games/openarena/baseoa/*.pk3 "$folder/"
cp files/usr/share/doc/openarena-data/copyright "$folder/"
echo "levels are in $folder"
