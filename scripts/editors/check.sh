#!/usr/bin/env bash
# check.sh: compares what the extension for VS Code and the mode of Emacs say of programs, transcripts and pages with
# what the scanner of the language says, in the engines that they are for; and tries the rest of the mode.
# Called by ./check --packages; needs a distribution (./build), npm and Emacs.
set -euo pipefail
cd "$(dirname "$0")/../.."
# shellcheck source=scripts/jdk.sh
. scripts/jdk.sh
find_jdk
. ./.build/current
for tool in npm emacs; do
  command -v "$tool" >/dev/null || { echo "editors: no $tool: apt-get install npm emacs-nox" >&2; exit 1; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 130' INT TERM HUP
mkdir "$work/kinds"
git ls-files -z editors/tricky.u '*.u' '*.u-session' 'docs/*.md' README.md |
  xargs -0 "$jdk/bin/java" -XX:TieredStopAtLevel=1 -cp "$(printf '%s:' "$dist"/lib/*.jar)" scripts/editors/Kinds.java "$work/kinds"
cp -R editors/vscode "$work/"
(cd "$work/vscode" && npm ci --ignore-scripts --no-audit --no-fund) >"$work/npm.log" 2>&1 </dev/null ||
  { cat "$work/npm.log" >&2; exit 1; }
node "$work/vscode/test/agreement.mjs" "$work/kinds"
URBI_KINDS=$work/kinds emacs -Q --batch -L editors/emacs -l urbiscript-mode-test -f ert-run-tests-batch-and-exit \
  >"$work/emacs.log" 2>&1 || { cat "$work/emacs.log" >&2; exit 1; }
grep '^Emacs mode:' "$work/emacs.log"
# It compiles without a warning. Emacs moves what it has compiled to where it belongs: not to /dev/null, whose place it would take.
cp editors/emacs/urbiscript-mode.el "$work/"
emacs -Q --batch --eval '(setq byte-compile-error-on-warn t)' -f batch-byte-compile "$work/urbiscript-mode.el"
