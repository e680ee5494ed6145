# shellcheck shell=bash
# SPDX-License-Identifier: Apache-2.0
# To be sourced by what runs JavaScript: a Node.js comes first on PATH that Playwright and Vite accept. That is the machine's own
# where it is new enough (Debian 12's is not), else the one of package.json beside this file, which npm brings into this folder.
#   node_packages FOLDER   brings what FOLDER's lock file names, unless it is there; FOLDER as from the repository's root

node_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

node_packages() (
  cd "$node_root/$1" || return
  exec 9<package-lock.json
  flock 9  # two suites may ask at the same time
  cmp -s package-lock.json node_modules/.installed && return
  echo "npm ci in $1" >&2
  npm ci --silent --no-audit --no-fund && cp package-lock.json node_modules/.installed && return
  echo "npm ci in $1 failed; scripts/deps web installs npm" >&2
  return 1
)

node_is_new() {
  node -e 'const [major, minor] = process.versions.node.split(".").map(Number);
           process.exit(major > 20 || (major === 20 && minor >= 19) ? 0 : 1)' 2>/dev/null
}

if ! node_is_new; then
  node_packages tools/node
  for node_bin in "$node_root"/tools/node/node_modules/node-linux-*/bin; do PATH=$node_bin:$PATH; done
  export PATH
  node_is_new || { echo "tools/node has no Node.js for $(uname -m); 20.19 or newer is needed" >&2; exit 1; }
fi
