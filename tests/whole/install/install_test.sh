#!/usr/bin/env bash
# install_test.sh library BUILD: a small program is built against what `cmake --install` puts into a folder.
# install_test.sh package BUILD: the Debian package that CPack makes is unpacked, and its programs run where neither
# sources nor build are to be found.
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
  build=$(cd "$2" && pwd)
  cpack --config "$2/CPackConfig.cmake" -G DEB -B "$folder" >/dev/null
  dpkg-deb --extract "$folder"/raysteps_*.deb "$folder/root"
  cd "$folder"
  sources=$(cd "$here/../../.." && pwd)
  raysteps() {
    bwrap --dev-bind / / --tmpfs "$sources" --tmpfs "$build" --bind "$folder" "$folder" --chdir "$folder" \
      root/usr/bin/raysteps "$@"
  }
  bwrap --dev-bind / / true 2>/dev/null || exit 77
  raysteps --version
  raysteps check --scene compact:2 --export own.rstree
  raysteps check --scene compact:2 --tree own.rstree
  raysteps trees to_npz own.rstree own.npz
  raysteps 06 --scene compact:2 --tree own.rstree --size 32
  # A model that another program of the package reads.
  printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >one.stl
  raysteps 03 --scene one.stl --size 32
  for family in root/usr/share/raysteps/docs/conformance/suite/*; do [ -e "$family" ]; done
  raysteps conformance --help >help
  [ ! -e root/usr/lib/raysteps/visualizer ] || raysteps view compact:2 --pixel 200,200 --screenshot view.png
  # Where its own data are gone too, it says which.
  mv root/usr/share/raysteps/shaders root/usr/share/raysteps/elsewhere
  ! raysteps 06 --scene compact:2 --size 32 2>said || exit 1
  grep -q 'shaders' said
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
