# Sourced by scripts/packages: the extension for VS Code. What is for Emacs is in the folder of the programs.
command -v npm >/dev/null || { say "no npm, which packs the extension for VS Code: apt-get install npm"; exit 1; }
say "packing the extension for VS Code…"
extension=$made/work/vscode
cp -R editors/vscode "$extension"
cp LICENSE "$extension/LICENSE.txt"
rm -rf "$extension/node_modules"
(cd "$extension" && npm ci --ignore-scripts --no-audit --no-fund &&
  node_modules/.bin/vsce package --no-dependencies --allow-missing-repository -o "$made/urbiscript-$version.vsix") \
  >"$made/work/vscode.log" 2>&1 </dev/null || { cat "$made/work/vscode.log" >&2; exit 1; }
finished "$made/urbiscript-$version.vsix"
