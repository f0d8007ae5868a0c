# shellcheck shell=bash
# Shared by the tools in this folder: messages, missing packages, configure and build. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
program="tools/$(basename "$0")"
# shellcheck source=tools/packages.sh
source "$root/tools/packages.sh"

say() { printf '\n== %s: %s\n' "$program" "$*"; }

# stop <exit code> <message...>
stop() {
  local code=$1
  shift
  printf '%s: %s\n' "$program" "$*" >&2
  exit "$code"
}

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Prints those lines "package: reason" of its arguments whose package is missing.
missing_lines() {
  local line
  printf '%s\n' "$@" | while IFS= read -r line; do
    [ -n "$line" ] || continue
    is_installed "${line%%:*}" || printf '%s\n' "$line"
  done
}

# Runs a command with the rights to install packages. Sudo may ask for a password only on a terminal.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif [ -t 0 ]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

may_become_root() {
  [ "$(id -u)" -eq 0 ] && return 0
  command -v sudo >/dev/null 2>&1 || return 1
  [ -t 0 ] || sudo -n true 2>/dev/null
}

run_apt() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Dpkg::Use-Pty=0 "$@"
}

# need_packages <lists...>: installs what is missing of them, and says what and why.
need_packages() {
  if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
    say "no apt here: the libraries named in tools/packages.sh are taken to be installed"
    return
  fi
  local lines names
  lines=$(missing_lines "$@")
  [ -n "$lines" ] || return 0
  mapfile -t names < <(printf '%s\n' "$lines" | cut -d: -f1)
  say "missing packages (of Debian 12):"
  printf '%s\n' "$lines" | sed 's/^/  /'
  may_become_root || stop 2 "neither root nor sudo is at hand. Have these installed, then run $program again:
  apt-get install --no-install-recommends ${names[*]}"
  run_apt update || stop 2 "apt-get update failed: check the network and /etc/apt/sources.list"
  run_apt install --no-install-recommends "${names[@]}" || stop 2 "apt-get could not install: ${names[*]}"
}

# Compilers that fill the memory are slower than fewer of them: 1.5 GB are allowed to each.
parallel_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1500000)}' /proc/meminfo 2>/dev/null)
  memory=${memory:-$cores}
  [ "$memory" -ge 1 ] || memory=1
  [ "$memory" -lt "$cores" ] && cores=$memory
  echo "$cores"
}

# A build folder that came along with a moved or copied checkout still points to the old place.
drop_foreign_build() {
  local cache="$root/build/$1/CMakeCache.txt" home
  [ -f "$cache" ] || return 0
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$cache")
  [ "$home" = "$root" ] || rm -rf "${root:?}/build/$1"
}

# Options given to every configuration, beside those of the preset. What this machine cannot run is not built for it.
configure_options=()
if [ -r /proc/cpuinfo ] && ! grep -qw avx512vl /proc/cpuinfo; then
  configure_options+=(-DORBEARING_AVX512=OFF)
fi

# build <preset> [targets...]
build() {
  local preset=$1
  shift
  say "configuring and building preset $preset in build/$preset"
  drop_foreign_build "$preset"
  local log
  log=$(cmake -S "$root" --preset "$preset" "${configure_options[@]}" 2>&1) || {
    printf '%s\n' "$log"
    return 1
  }
  cmake --build "$root/build/$preset" --parallel "$(parallel_jobs)" ${1:+--target "$@"}
}

# Four at a time on two cores: those of browsers, servers and killed runs wait more than they compute.
# run_tests <preset> [ctest options...]
run_tests() {
  local preset=$1
  shift
  say "running the tests of preset $preset"
  local result=0
  ctest --test-dir "$root/build/$preset" --output-on-failure --no-tests=error -j 4 "$@" || result=$?
  skipped_within "$root/build/$preset/Testing/Temporary/LastTest.log"
  return "$result"
}

# ctest tells of programs that are skipped; what one of them leaves out is in its log, with the reason in the next line.
skipped_within() {
  local reasons
  reasons=$(sed -n -E "s|^$root/tests/([^:]*):[0-9]+: Skipped\$|\1|p;T;n;p" "$1" | paste -d: - - | sort | uniq -c) || return 0
  [ -z "$reasons" ] || printf 'Left out within these files:\n%s\n' "$reasons"
}

minutes_since() {
  printf '%d min %02d s' $(((SECONDS - $1) / 60)) $(((SECONDS - $1) % 60))
}

# debian_source <package> <folder>: its source, as Debian builds it, in that folder.
debian_source() {
  local sources="$2"
  compgen -G "$sources/$1-*/" >/dev/null && return
  mkdir -p "$sources/lists/partial"
  local mirror suite  # of the machine's own packages
  read -r mirror suite < <(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' | grep -m1 -v -- -)
  cat >"$sources/debian.sources" <<LIST
Types: deb-src
URIs: $mirror
Suites: $suite
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
LIST
  local apt=(apt-get -q -o "Dir::State::lists=$sources/lists" -o "Dir::Etc::sourcelist=$sources/debian.sources"
    -o Dir::Etc::sourceparts=/dev/null -o "Dir::Cache=$sources" -o APT::Sandbox::User=)
  [ -n "$(compgen -G "$sources/lists/*Sources*")" ] || "${apt[@]}" update
  (cd "$sources" && "${apt[@]}" source --only-source "$1")
}
