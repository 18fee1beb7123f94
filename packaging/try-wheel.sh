#!/usr/bin/env bash
# Installs the wheel in an environment of its own, with no Rust in reach, computes a first force and runs the package's tests;
# with ROOT the same in an older Debian:
#
#     packaging/try-wheel.sh WHEELS ENVIRONMENT [ROOT [SUITE]]
#
# WHEELS: the folder of the wheel. ROOT becomes a root file system of about 500 MB, and is used again the next time; to be run as
# root. SUITE: bullseye, with glibc 2.31 and the oldest Python that the package takes, 3.9; numpy is the oldest that it takes too.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1"/fmc_contact-*.whl) environment=$2 root=${3:-} suite=${4:-bullseye}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The first program in Python of the page is the one that needs nothing but numpy.
sed -n '/^```python$/,/^```$/ { /^```/d; p; /^print("overlap/q }' docs/first-contact.md >"$work/squares.py"
expect() { tee "$work/printed"; grep -q 'force on the second square \[79[34]\.' "$work/printed"; }

python3 -m zipfile -l "$wheel" >"$work/files"
for file in LICENSE-MIT LICENSE-APACHE LICENSES-COMPILED-IN; do
  grep -q "\.dist-info/licenses/$file " "$work/files" || { echo "$wheel lacks $file" >&2; exit 1; }
done
python3 -m venv --clear "$environment"
"$environment/bin/python" -m pip install -q --only-binary :all: "$wheel" pytest scipy
bare() { env -i HOME="$HOME" PATH=/usr/bin:/bin "$@"; }
bare sh -c '! command -v rustc' && (cd "$work" && bare "$environment/bin/python" squares.py) | expect
bare "$environment/bin/python" -m pytest -q bindings/python

if [ -n "$root" ]; then
  run() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
  if [ ! -e "$root/ready" ]; then
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | grep /debian/ | grep -v security | head -1)
    command -v debootstrap >/dev/null || { apt-get update -q; apt-get install -q -y --no-install-recommends debootstrap; }
    rm -rf "$root" && mkdir -p "$root"
    debootstrap --variant=minbase --include=ca-certificates "$suite" "$root" "$mirror"
    run apt-get -q -o Acquire::Check-Valid-Until=false update
    run apt-get -q -y --no-install-recommends install python3-pip python3-pytest
    touch "$root/ready"
  fi
  oldest=$(sed -n 's/^dependencies = \["numpy>=\(.*\)"\]/\1/p' bindings/python/pyproject.toml)
  "$environment/bin/python" -m pip download -q -d "$work" --no-deps --only-binary :all: --python-version 3.9 \
    --platform manylinux2010_x86_64 --platform "manylinux2014_$(uname -m)" "numpy==$oldest.0"
  # As in a checkout: the tests look for the header, and for the pages whose programs they run.
  rm -rf "$root/try" && mkdir -p "$root/try/bindings/python" "$root/try/docs"
  cp "$wheel" "$work/squares.py" "$work"/numpy-*.whl "$root/try"
  cp -r include "$root/try" && cp -r bindings/python/tests bindings/python/README.md "$root/try/bindings/python"
  cp docs/*.md "$root/try/docs"
  run sh -c 'python3 -m pip install -q --no-index --no-deps --target /try/packages /try/*.whl'
  run sh -c 'ldd --version | head -1; python3 --version'
  run env PYTHONPATH=/try/packages python3 /try/squares.py | expect
  run env PYTHONPATH=/try/packages python3 -m pytest -q /try/bindings/python/tests
fi
echo "$(basename "$wheel") works"
