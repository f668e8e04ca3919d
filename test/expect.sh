# SPDX-License-Identifier: Apache-2.0
# Sourced by the scripts that try one thing after the other and count what is as expected. They end with `summarise`.
passed=0 failed=0
said=$(mktemp)  # what the last command said; who sources this removes it

# expect WHAT COMMAND...: counts, with the time; shows what a command that failed said.
expect() {
  local what=$1 begin=$SECONDS
  shift
  if "$@" >"$said" 2>&1; then
    passed=$((passed + 1)) && echo "ok   $what, $((SECONDS - begin)) s"
  else
    failed=$((failed + 1)) && echo "FAIL $what" && tail -n 40 "$said"
  fi
}

# count COMMAND...: of tests, whose last line is `N passed, N failed...`; without one it counts as one that failed.
count() {
  local good bad
  "$@" 2>&1 | tee "$said" | grep -v '^\(Starting\|Finished\) '
  read -r good bad < <(sed -n 's/^\([0-9]*\) passed, \([0-9]*\) failed.*/\1 \2/p' "$said" | tail -n 1)
  passed=$((passed + ${good:-0})) failed=$((failed + ${bad:-1}))
}

# The last line and the exit code of a script.
summarise() {
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ]
}
