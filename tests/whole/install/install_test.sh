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
  # That of the distribution has its NumPy; another one may come first in the path.
  python=/usr/bin/python3
  "$python" -c 'import numpy' 2>/dev/null && dpkg-query -W pybind11-dev >/dev/null 2>&1 || exit 77
  cmake -S "$2" -B "$2/build/python" -G Ninja -DRAYSTEPS_PYTHON=ON -DRAYSTEPS_TESTS=OFF \
    -DPYTHON_EXECUTABLE="$python" >/dev/null
  cmake --build "$2/build/python" --target raysteps_python >/dev/null
  PYTHONPATH=$2/build/python/chapters/check "$python" -B "$here/test_module.py"
  ;;
esac
