# shellcheck shell=bash
# What ./run and ./test share; sourced with the current directory at the project's root.
# All it has to say goes to standard error: standard output belongs to the tool.

say() { printf 'wedgesim: %s\n' "$*" >&2; }

# install_packages run|test: installs the packages of packages.txt that are missing, those of the
# tests only for `test`. One question to dpkg when nothing is missing.
install_packages() {
  local wanted installed missing as_root=()
  if ! command -v dpkg-query > /dev/null; then
    say 'not a Debian system: packages.txt lists what must be there'
    return
  fi
  if [ "$1" = test ]; then
    wanted=$(sed 's/#.*//; s/ *$//; /^$/d' packages.txt | sort)
  else
    wanted=$(sed '/# test$/d; s/#.*//; s/ *$//; /^$/d' packages.txt | sort)
  fi
  # An npm from elsewhere brings its own node, and may conflict with Debian's.
  if command -v npm > /dev/null; then wanted=$(grep -vx -e nodejs -e npm <<< "$wanted"); fi
  # dpkg-query fails when it knows nothing of a name: that name is missing, no more.
  # shellcheck disable=SC2016,SC2086
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2> /dev/null |
    sed -n 's/^installed //p' | sort -u) || true
  missing=$(comm -23 <(echo "$wanted") <(echo "$installed") | tr '\n' ' ')
  [ -n "${missing// /}" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo > /dev/null; then
      say "not root and no sudo; as root: apt-get install -y --no-install-recommends $missing"
      exit 1
    fi
    as_root=(sudo)
  fi
  say "installing: $missing"
  # shellcheck disable=SC2086
  quietly build/install.log "${as_root[@]}" sh -c '
    export DEBIAN_FRONTEND=noninteractive
    apt-get update && apt-get install -o DPkg::Lock::Timeout=300 -y --no-install-recommends "$@"' sh $missing
}

# quietly LOG COMMAND...: only a failure shows what the command printed.
quietly() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" > "$log" 2>&1 < /dev/null; then
    cat "$log" >&2
    say "failed: $*"
    exit 1
  fi
}

# build FOLDER TARGET...: on a terminal one line counts the steps; a failure shows its messages.
build() {
  local folder=$1 log=$1/build.log
  shift
  if ! cmake --build "$folder" --target "$@" 2>&1 < /dev/null | tee "$log" | show_progress; then
    grep -v '^\[[0-9]*/[0-9]*\]' "$log" >&2 || true
    say "the build failed; all it printed is in $log"
    exit 1
  fi
}

show_progress() {
  local line shown=
  while IFS= read -r line; do
    [[ $line =~ ^\[([1-9][0-9]*/[0-9]+)\] ]] || continue
    if [ -t 2 ]; then
      printf '\rwedgesim: building %s ' "${BASH_REMATCH[1]}" >&2
    elif [ -z "$shown" ]; then
      say 'building'
    fi
    shown=yes
  done
  [ -z "$shown" ] || ! [ -t 2 ] || printf '\n' >&2
}

# One setup at a time: a second one waits here until the first releases or ends.
lock_setup() {
  mkdir -p build
  exec 9> build/.lock
  flock 9
}
unlock_setup() { exec 9>&-; }
