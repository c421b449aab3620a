#!/usr/bin/env bash
# Times two versions of this crate in one process, by turns, and prints new over old for every family of
# scenes, kind of ray, scalar and number of objects; under two minutes. The checkout that one stands in is the
# new version, with what is not committed yet; the old one is any revision from 0.7.0 on. CARGO_TARGET_DIR says where to
# build, target/ unless said.
#
#   benches/ab.sh [--units OLD[:NEW]] REVISION [filters]
#   benches/ab.sh HEAD
#   benches/ab.sh HEAD~3 --family city,hall --n 12,1000 --scalar f32 --rays tiles,shadows --way single
#   benches/ab.sh --units 1:16 .        one codegen unit against sixteen, of the same source
#
# REVISION `.` is the checkout itself. --units: codegen units of the crate, 16 unless said (as `cargo build
# --release` of a user has it). Filters, each a list with commas:
#   --family   city hall atoms stadium sticks beams sizes snowflake cubes room atelier mix shelves forest lattice
#   --rays     tiles rows parallel mirrors rough diffuse "no order" shadows shuffled "shuf. shad."
#   --way      list list-batch (both up to 64 objects), single batch (of the tree, which fewer than 10 do not have);
#              for first hits `list` is the function `premiere_intersection(&objets, &rayon)`
#   --n        3,12,48,192,1000,10000 unless said; room and atelier have their own
#   --scalar   f32,f64
# and, each a single value:
#   --set AVX-512 | AVX2 | SSE2   the instructions of the tree; the best of the machine unless said
#   --seed 1    of the scenes and of the rays that leave them
#   --bands 8   how much of the picture, 1 to 50 bands of 4,800 rays
#   --turns 4   of a round; the least time of 2 to 6 rounds counts, until their ratio stands
#   --call 64   rays in a call of a batch, 4096 at most and unless said
#   --places OLD[:NEW]  how many times places(n) are lent; 2 unless said, so that long boxes are cut into pieces
#   --ns        the time that is divided by as well, in ns a ray
#   --over      the new version alone: its rays one by one over its batches
# `!` marks a cell in which the two versions do not agree to the bit. A version beside itself stays within 5 %,
# except for lists and rooms of some ten objects (up to 40 %): where the code comes to lie decides what the
# processor predicts. Run it again, or with `--bands 50`.
set -euo pipefail

aide() { sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"; }
unites=16:16
[ "${1-}" != --units ] || { unites=$2; shift 2; }
case "${1---help}" in -*) aide; exit ;; esac
revision=$1
shift

bancs=$(cd "$(dirname "$0")" && pwd)
racine=$(git rev-parse --show-toplevel)
cible=${CARGO_TARGET_DIR:-$racine/target}
ab=$cible/ab
if [ "$revision" = . ]; then
  revision=$(git -C "$racine" stash create)
  revision=${revision:-HEAD}
fi
commit=$(git -C "$racine" rev-parse "$revision^{commit}")
version() { sed -n 's/^version = "\(.*\)"/\1/p' "$1/Cargo.toml" | head -1; }

# Unpacked only if it is another one, so that cargo does not compile it again.
mkdir -p "$ab/programme"
if [ "$(cat "$ab/commit" 2>/dev/null)" != "$commit" ]; then
  rm -rf "$ab/avant"
  mkdir "$ab/avant"
  git -C "$racine" archive "$commit" | tar -xm -C "$ab/avant"
  # Two packages of one name need two versions.
  sed -i '0,/^version = .*/s//version = "0.0.0-avant"/' "$ab/avant/Cargo.toml"
  echo "$commit" > "$ab/commit"
fi

cat > "$ab/programme/Cargo.toml" <<FIN
[package]
name = "ab"
version = "0.0.0"
edition = "2024"
[[bin]]
name = "ab"
path = "$bancs/banc/ab.rs"
[features]
seule = []
[workspace]
[dependencies]
avant = { package = "lancer-rayon", path = "$ab/avant", features = ["serde"] }
banc = { path = "$bancs/banc" }
exemples = { path = "$racine/docs/exemples", default-features = false }
lancer-rayon = { path = "$racine", features = ["serde"] }
[profile.release.package]
"lancer-rayon@0.0.0-avant" = { codegen-units = ${unites%:*} }
"lancer-rayon@$(version "$racine")" = { codegen-units = ${unites#*:} }
FIN
[ -e "$ab/programme/Cargo.lock" ] || cp "$racine/Cargo.lock" "$ab/programme/"

cargo build --release --quiet --manifest-path "$ab/programme/Cargo.toml" --target-dir "$cible"
echo "old: $(git -C "$racine" log -1 --format='%h %s' "$commit"); new: $racine; codegen units $unites"
exec "$cible/release/ab" "$@"
