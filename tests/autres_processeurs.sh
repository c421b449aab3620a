#!/usr/bin/env bash
# The same bits on other processors: runs the tests that compare bits on a 64-bit ARM, a 64-bit RISC-V and a
# big-endian IBM Z under qemu, on a 32-bit x86, which this processor is as well, and on WebAssembly under node,
# with its 128-bit vectors and without.
#
#   tests/autres_processeurs.sh [FOLDER [NAME…]]
#
# The folder is ${TMPDIR:-/tmp}/autres-processeurs; the names are those of the loop at the end, all unless given.
#
# Compilers, standard libraries and emulators are those of Debian unstable, unpacked into that folder
# (some 5 GB) and run there by chroot: nothing is installed and nothing written elsewhere, except the
# crates that cargo adds to its own cache. It takes an amd64 Debian, and root or user namespaces.
# CARGO_BUILD_JOBS is passed on, LANCER_RAYON_CAS is not. Takes an hour or more, and is no part of CI.
set -euo pipefail
cd "$(dirname "$0")/.."

rater() {
  echo "autres_processeurs: $1" >&2
  exit 1
}

for outil in apt-get awk cargo chroot dpkg-deb mount unshare; do
  command -v "$outil" > /dev/null || rater "the program $outil is missing"
done
dossier=${1:-${TMPDIR:-/tmp}/autres-processeurs}
noms=("${@:2}")
[ ${#noms[@]} -gt 0 ] || noms=(aarch64 riscv64 s390x i686 wasm32-simd128 wasm32)
mkdir -p "$dossier"/{apt/lists/partial,apt/archives/partial,racine}
dossier=$(cd "$dossier" && pwd)
racine=$dossier/racine
# What is mounted in a namespace of its own vanishes with it.
espace=(unshare --mount)
[ "$(id -u)" = 0 ] || espace+=(--map-root-user)
"${espace[@]}" mount --rbind /proc "$racine" || rater "neither root nor user namespaces to mount in"

# The machine's own mirror and proxies, but not its hooks, which touch the system's files.
cle=/usr/share/keyrings/debian-archive-keyring.gpg
[ -e "$cle" ] || rater "the package debian-archive-keyring is missing"
miroir=$(apt-get update --print-uris | awk -F/dists/ '/\/debian\/dists\// && !n++ { print substr($1, 2) }')
[ -n "$miroir" ] || rater "apt knows no mirror of Debian"
echo "deb [signed-by=$cle] $miroir unstable main" > "$dossier/apt/sources.list"
: > "$dossier/apt/status"
reglages=$(apt-config dump Acquire | grep -v IndexTargets)
cat > "$dossier/apt/reglages" << FIN
$reglages
Dir::Etc { main "/dev/null"; parts "/dev/null"; preferences "/dev/null"; preferencesparts "/dev/null"; };
Dir::Etc { sourcelist "$dossier/apt/sources.list"; sourceparts "/dev/null"; };
Dir { State "$dossier/apt"; State::status "$dossier/apt/status"; Cache "$dossier/apt"; Log "$dossier/apt"; };
APT { Architectures { "$(dpkg --print-architecture)"; "arm64"; "i386"; "riscv64"; "s390x"; }; };
APT { Install-Recommends "false"; Sandbox::User "root"; };
FIN
export APT_CONFIG=$dossier/apt/reglages
apt-get -q=2 update || rater "the mirror has no index of Debian unstable"
# The linker for WebAssembly that fits the LLVM of this rustc.
lld=$(apt-cache depends rust-llvm | grep -o 'lld-[0-9]*') || rater "unstable has no rust-llvm"
apt-get -q=2 autoclean
apt-get -q=2 -y --download-only install base-files cargo rustc libstd-rust-dev-wasm32 "$lld" nodejs \
  qemu-user gcc-{aarch64,i686,riscv64,s390x}-linux-gnu libc6-dev-{arm64,i386,riscv64,s390x}-cross ||
  rater "unstable lacks some packages just now"
# Without what they depend on: LLVM for the other processors.
(cd "$dossier/apt/archives" && apt-get -q=2 download libstd-rust-dev:{arm64,i386,riscv64,s390x}) ||
  rater "unstable has no standard library of Rust for one of the processors"
unset APT_CONFIG
(cd "$dossier/apt/archives" && ls ./*.deb) > "$dossier/paquets"
if ! cmp -s "$dossier/paquets" "$dossier/deballes"; then
  rm -rf "$racine" "$dossier/deballes"
  mkdir "$racine"
  for paquet in "$dossier"/apt/archives/*.deb; do
    dpkg-deb -x "$paquet" "$racine" || rater "cannot unpack $paquet"
  done
  # Links that an installation would have made.
  ln -s gcc "$racine/usr/bin/cc"
  ln -s "$lld" "$racine/usr/bin/rust-lld"
  mv "$dossier/paquets" "$dossier/deballes"
fi

# A copy without the benches and the development dependencies that none of these tests needs: some
# want threads or a C compiler, which WebAssembly has not here.
rm -rf "$racine"/{essai,vendor}
mkdir -p "$racine"/{essai,.cargo}
cp -r Cargo.toml Cargo.lock docs src tests "$racine/essai"
sed -i -E '/^(allocation-counter = |(indicatif|png|rayon)\.workspace)/d; /^default-members/d; s/^members = .*/members = []/' \
  "$racine/essai/Cargo.toml"
(cd "$racine" && : > .cargo/config.toml &&
  cargo vendor --manifest-path essai/Cargo.toml vendor > .cargo/config.toml 2> "$dossier/vendor.log") ||
  rater "cargo cannot get the crates, see $dossier/vendor.log"
cat > "$racine/essai/node.mjs" << 'FIN'
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";
const args = process.argv.slice(2);
const wasi = new WASI({ version: "preview1", args, env: process.env, preopens: { ".": "." } });
const module = await WebAssembly.compile(await readFile(args[0]));
process.exit(wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject())));
FIN

# Runs the tests under a name on a target, given what cargo has to know of it. On WebAssembly the first panic
# ends the whole file, and a captured message would be lost.
echec=0
eprouver() {
  local nom=$1 cible=$2 variable
  variable=CARGO_TARGET_$(tr a-z- A-Z_ <<< "$cible")_
  shift 2
  echo "== $nom" | tee "$dossier/$nom.log"
  # shellcheck disable=SC2016
  "${espace[@]}" sh -c 'mount --rbind /dev "$0/dev" && mount --rbind /proc "$0/proc" && exec "$@"' \
    "$racine" env -i PATH=/usr/sbin:/usr/bin HOME=/root "${@/#/$variable}" CARGO_TARGET_DIR=/cible \
    RUST_TEST_NOCAPTURE=1 CARGO_BUILD_JOBS="${CARGO_BUILD_JOBS:-default}" chroot "$racine" \
    cargo test --frozen --no-fail-fast --manifest-path essai/Cargo.toml --target "$cible" \
    --test memes_bits 2>&1 |
    tee -a "$dossier/$nom.log" || echec=1
}
emuler() {
  eprouver "$1" "$2-unknown-linux-gnu" "LINKER=$1-linux-gnu-gcc" "RUNNER=$3 -L /usr/$1-linux-gnu"
}
i686=/usr/i686-linux-gnu/lib
node="RUNNER=node --no-warnings /essai/node.mjs"
for nom in "${noms[@]}"; do
  case $nom in
    aarch64 | s390x) emuler "$nom" "$nom" "qemu-$nom" ;;
    riscv64) emuler "$nom" riscv64gc "qemu-$nom" ;;
    i686)
      eprouver "$nom" "$nom-unknown-linux-gnu" "LINKER=$nom-linux-gnu-gcc" \
        "RUNNER=$i686/ld-linux.so.2 --library-path $i686"
      ;;
    wasm32-simd128) eprouver "$nom" wasm32-wasip1 RUSTFLAGS=-Ctarget-feature=+simd128 "$node" ;;
    wasm32) eprouver "$nom" wasm32-wasip1 RUSTFLAGS=-Ctarget-feature=-simd128 "$node" ;;
    *) rater "no processor is called $nom" ;;
  esac
done

for nom in "${noms[@]}"; do
  awk '/ Running tests/ { fichier = $2; fin = "DID NOT FINISH" }
    /^test result: / { fin = $4 " passed, " $6 " failed, " $NF }
    END { print FILENAME ": " fichier ": " fin }' "$dossier/$nom.log"
done
[ $echec = 0 ] || rater "a test failed or did not run, see above"
