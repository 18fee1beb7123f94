#!/usr/bin/env bash
# The Debian packages, from what is built: packaging/debian/build.sh LIBRARIES COMMAND OUT
#
# LIBRARIES: the folder of libfmc_contact.so and .a; COMMAND: the program fmc; OUT: where the packages go. Needs dpkg-dev.
# The maintainer is that of DEBFULLNAME and DEBEMAIL, as for all tools of Debian.
set -euo pipefail
cd "$(dirname "$0")/../.."
libraries=$(realpath "$1") command=$(realpath "$2")
mkdir -p "$3" && out=$(realpath "$3")

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -1)
soversion=${version%.*}
repository=$(sed -n 's/^repository = "\(.*\)"/\1/p' Cargo.toml)
maintainer="${DEBFULLNAME:-The fmc-contact developers} <${DEBEMAIL:-fmc-contact@users.noreply.github.com}>"
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
multiarch=$(dpkg-architecture -qDEB_HOST_MULTIARCH)
lib=libfmc-contact$soversion

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fill() { sed -e "s|@SOVERSION@|$soversion|g; s|@REPOSITORY@|$repository|g; s|@MAINTAINER@|$maintainer|g" "$@"; }
mkdir "$work/debian"
fill packaging/debian/control.in >"$work/debian/control"
cat >"$work/debian/changelog" <<END
fmc-contact ($version-1) unstable; urgency=medium

  * Release $version; what has changed is in changelog.gz.

 -- $maintainer  $(date -R -u -d "@$SOURCE_DATE_EPOCH")
END
sed -n '/^Permission/,$ { s/^$/./; s/^/ /; p }' LICENSE-MIT >"$work/mit"
fill packaging/debian/copyright | sed -e "/^@MIT@$/ { r $work/mit" -e 'd }' >"$work/copyright"

# Everything as it is installed, then divided among the packages.
all=$work/all
make -s install BUILT="$libraries" DESTDIR="$all" PREFIX=/usr LIBDIR="lib/$multiarch"
make -s install-command COMMAND="$command" DESTDIR="$all" PREFIX=/usr
make -s install-python DESTDIR="$all" PREFIX=/usr LIBDIR="lib/$multiarch" PYTHONDIR=lib/python3/dist-packages
gzip -9n "$all"/usr/share/man/man1/*
move() { # PACKAGE PATH…
  for path in "${@:2}"; do
    mkdir -p "$work/$1/$(dirname "$path")" && mv "$all/$path" "$work/$1/$path"
  done
}
(cd "$all" && ls -d usr/lib/"$multiarch"/*.so.*) >"$work/runtime"
move "$lib" $(cat "$work/runtime")
move python3-fmc-contact usr/lib/python3
move libfmc-contact-dev usr/include usr/lib
move fmc-tools usr/bin usr/share/man
for document in README.md CITATION.cff; do
  move libfmc-contact-dev "usr/share/doc/fmc-contact/$document"
done
mv "$work/libfmc-contact-dev/usr/share/doc/fmc-contact" "$work/libfmc-contact-dev/usr/share/doc/libfmc-contact-dev"

packaging/licences fmc-contact | gzip -9n >"$work/$lib.crates"
packaging/licences fmc | gzip -9n >"$work/fmc-tools.crates"
cd "$work"
for package in "$lib" libfmc-contact-dev python3-fmc-contact fmc-tools; do
  doc=$package/usr/share/doc/$package
  mkdir -p "$doc" "$package/DEBIAN"
  cp copyright "$doc"
  gzip -9nc debian/changelog >"$doc/changelog.Debian.gz"
  gzip -9nc "$OLDPWD/CHANGELOG.md" >"$doc/changelog.gz"
  if [ -e "$package.crates" ]; then cp "$package.crates" "$doc/compiled-in.txt.gz"; fi
  binaries=$(find "$package/usr/bin" "$package/usr/lib/$multiarch" -type f \( -name '*.so.*' -o -name fmc \) 2>/dev/null || true)
  : >substvars
  if [ -n "$binaries" ]; then dpkg-shlibdeps -Tsubstvars -S"$package" $binaries; fi
  for script in postinst prerm; do
    source=$OLDPWD/packaging/debian/$package.$script
    if [ -e "$source" ]; then install -m 755 "$source" "$package/DEBIAN/$script"; fi
  done
  if [ "$package" = "$lib" ]; then
    echo "libfmc_contact $soversion $lib (>= $soversion.0)" >"$package/DEBIAN/shlibs"
    echo "activate-noawait ldconfig" >"$package/DEBIAN/triggers"
  fi
  dpkg-gencontrol -p"$package" -P"$package" -Tsubstvars -O"$package/DEBIAN/control" -f"$work/files" >/dev/null
  (cd "$package" && find usr -type f -print0 | sort -z | xargs -0 md5sum) >"$package/DEBIAN/md5sums"
  chmod -R u=rwX,go=rX "$package"
  find "$package/usr/lib" -name "*.so.*" -type f -exec chmod a-x {} + 2>/dev/null || true
  dpkg-deb -Zxz --root-owner-group --build "$package" "$out" >/dev/null
done
ls -l "$out"/*"_$version-1_"*.deb
