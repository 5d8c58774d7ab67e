#!/usr/bin/env bash
# install_test.sh library BUILD: a small program is built against what `cmake --install` puts into a folder.
# install_test.sh package BUILD: the Debian package that CPack makes is unpacked, and its programs run.
# install_test.sh python SOURCES: the module of Python is built and asked. 77 where pybind11 is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

case $1 in
library)
  cmake --install "$2" --component library --prefix "$folder/prefix" >/dev/null
  cmake -S "$here/consumer" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/prefix" >/dev/null
  cmake --build "$folder/build" >/dev/null
  "$folder/build/consumer"
  ;;
package)
  cpack --config "$2/CPackConfig.cmake" -G DEB -B "$folder" >/dev/null
  dpkg-deb --extract "$folder"/raysteps_*.deb "$folder/root"
  cd "$folder"
  root/usr/bin/raysteps --version
  root/usr/bin/raysteps check --scene compact:2 --export own.rstree
  root/usr/bin/raysteps check --scene compact:2 --tree own.rstree
  root/usr/bin/raysteps trees to_npz own.rstree own.npz
  ;;
python)
  python3 -c 'import numpy' 2>/dev/null && cmake --find-package -DNAME=pybind11 -DCOMPILER_ID=GNU -DLANGUAGE=CXX \
    -DMODE=EXIST >/dev/null 2>&1 || exit 77
  cmake -S "$2" -B "$2/build/python" -G Ninja -DRAYSTEPS_PYTHON=ON -DRAYSTEPS_TESTS=OFF >/dev/null
  cmake --build "$2/build/python" --target raysteps_python >/dev/null
  PYTHONPATH=$2/build/python/chapters/check python3 -B "$here/test_module.py"
  ;;
esac
