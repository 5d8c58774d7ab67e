# What run.sh and test.sh share: installs what is missing. Sourced by both.
#
#   set_up run|view|book|test [--no-install]
#
# Asks nothing. With --no-install it only lists what is missing.

# What the programs are built from, and the model that they render.
packages_to_run=(
  g++ cmake ninja-build pkg-config
  libglm-dev libosmesa6-dev libegl-dev libglfw3-dev libimgui-dev python3-glad khronos-api
  libegl-mesa0 libgl1-mesa-dri
  libtinyobjloader-dev libassimp-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libfmt-dev libstb-dev
  libembree-dev libboost-dev glmark2-data gnuplot-nox fonts-dejavu-core python3
)

# What the visualizer is drawn with.
packages_to_view=(libvtk9-dev libzip-dev libx11-dev)

# What the book is made with: its pages, its formulas, and the pages of the interfaces.
packages_to_book=(mkdocs-material python3-pymdownx python3-pygments libjs-katex doxygen ca-certificates)
# npm fetches what draws its figures. It may be there already, from elsewhere, and then the package would be in its way.
if ! command -v npm >/dev/null; then
  packages_to_book+=(npm)
fi

# What the tests need on top: their libraries, a display without a screen, checkers of shaders and of JSON, git, the sandbox in
# which ./course grade runs, clang with its runtime, which fuzzes the loader, and gappa, which proves the bounds of
# docs/numerics.md.
packages_to_test=(
  catch2 librapidcheck-dev
  xvfb xauth xdotool libgl1 libglx-mesa0 glslang-tools python3-jsonschema git bubblewrap
  clang libclang-rt-dev clang-format gappa
)

# The browsers that read the book and run the playground. Ubuntu has none among its packages: there these tests are skipped.
packages_to_browse=()
if grep -qs '^ID=debian' /etc/os-release; then
  packages_to_browse=(chromium chromium-driver python3-selenium firefox-esr)
fi

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

can_test() {
  local package
  for package in catch2 librapidcheck-dev libembree-dev; do
    is_installed "$package" || return 1
  done
}

set_up() {
  local packages=("${packages_to_run[@]}") missing=() package administrator=()
  case "$1" in
  view) packages+=("${packages_to_view[@]}") ;;
  book) packages+=("${packages_to_view[@]}" "${packages_to_book[@]}") ;;
  test)
    packages+=("${packages_to_view[@]}" "${packages_to_book[@]}" "${packages_to_test[@]}" "${packages_to_browse[@]}")
    ;;
  esac
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "set-up: this system has no apt. If the build stops, install what these Debian packages hold:" >&2
    echo "  ${packages[*]}" >&2
    return 0
  fi
  for package in "${packages[@]}"; do
    is_installed "$package" || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    return 0
  fi
  if [ "${2:-}" = --no-install ]; then
    echo "set-up: these packages are missing:"
    echo "  apt-get install --no-install-recommends ${missing[*]}"
    exit 3
  fi
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "set-up: only root may install packages, and there is no sudo. Have this run, and start again:" >&2
      echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
      exit 3
    fi
    administrator=(sudo)
  fi
  echo "set-up: installing ${missing[*]}"
  # A file of settings that somebody has changed stays as it is, without a question.
  local log keep_files=(-o Dpkg::Options::=--force-confdef -o Dpkg::Options::=--force-confold)
  log=$(mktemp)
  # Where one of the sources fails, what is needed may come from the others: only the install decides.
  if ! { { "${administrator[@]}" apt-get update -q || true; } &&
    "${administrator[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get install -y -q --no-install-recommends "${keep_files[@]}" "${missing[@]}"; } >"$log" 2>&1 </dev/null; then
    tail -n 5 "$log" >&2
    echo "set-up: the packages could not be installed; the whole log is in $log." >&2
    exit 3
  fi
  rm -f "$log"
}
