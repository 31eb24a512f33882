#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# End-to-end tests of the built programs: validate_test.sh BUILD_DIR
# Prints one line a check; ends with exit code 1 at the first that fails.
set -uo pipefail

build=$(cd "${1:?usage: validate_test.sh BUILD_DIR}" && pwd)
validate=$build/validate
example=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/user/examples/ramp.toml
checks=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/end_to_end.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

# shellcheck source=validation/end_to_end.sh
source "$checks"
export XDG_CACHE_HOME=$work/cache # what is remembered elsewhere does not count
export COLUMNS=200 # sentences are looked for, which a narrow screen breaks

# ---- exit codes 0 and 1 -----------------------------------------------------------------------
holds 0 "the quick set passes" "$validate" --quick --jobs 2 --out quick
holds 0 "the example problem passes" "$validate" "$example" --out example
holds 0 "a problem that is named runs with --quick too" "$validate" "$example" --quick --out example
grep -q '"verdict":"pass"' example/latest/records.jsonl || failed "a problem with --quick" "it did not run"
holds 1 "tolerance scale 0 fails a case that is not exact" \
  "$validate" --case half-space/free-fall --tolerance-scale 0 --out zero
grep -q 'height after 0.1 s: measured' out || failed "tolerance scale 0" "no residual is shown"
holds 0 "a large tolerance scale passes it" \
  "$validate" --case half-space/free-fall --tolerance-scale 10 --out ten
grep -qF 'verdicts multiply each tolerance by 10 (--tolerance-scale)' err ||
  failed "a large tolerance scale" "no sentence says so"
grep -qF 'verdicts multiply each tolerance by 10 (--tolerance-scale)' ten/latest/records.jsonl ||
  failed "a large tolerance scale" "its record does not say so"
holds 0 "--help is a page" "$validate" --help
for word in --case --list --quick --out --jobs --tolerance-scale --set 'EXIT STATUS'; do
  grep -qF -- "$word" out || failed "--help is a page" "it lacks $word"
done

# ---- --list -----------------------------------------------------------------------------------
holds 0 "--list shows the cases" "$validate" --list --out listed
for name in half-space/free-fall 'incline/threshold/mu=0.9/azimuth=45/yaw=0' incline/below/creep/50%; do
  grep -qF "$name" out || failed "--list" "it lacks $name"
done
[ ! -e listed ] || failed "--list" "it made a report folder"
[ -z "$(cut -d' ' -f1 out | sort | uniq -d)" ] || failed "--list" "a name is there twice"
exits 0 "--list --case" "$validate" --list --case 'half-space/b*'
[ "$(wc -l <out)" -eq 2 ] || failed "--list --case 'half-space/b*'" "not the two cases"
passed "--list --case shows those that match"

# ---- time steps -------------------------------------------------------------------------------
holds 0 "time steps are compared where none is set" "$validate" --case incline/integrator/stop --set dt=1e-4 --out steps
grep -q '"verdict":"not-applicable"' steps/latest/records.jsonl || failed "incline/integrator/stop" "it compares one step"
holds 0 "the clamped box rests at twice its time step" \
  "$validate" --case paper/fig3-clamped-box --configuration quiet --set dt=4e-4 --out doubled_step
holds 0 "the clamped box rests at a sixteenth of its time step" \
  "$validate" --case paper/fig3-clamped-box --configuration quiet --finer 16 --out sixteenth
holds 1 "the clamped box at half its time step needs its hysteresis" \
  "$validate" --case paper/fig3-clamped-box/half-step --set hysteresis=0 --out unkept
# finer RUN WHAT: the run says that its steps are finer, and WHAT in its record how fine.
finer() {
  for where in err "$1/latest/records.jsonl"; do
    grep -qF 'time steps are 1/16 of the usual ones (--finer)' "$where" || failed "finer steps" "$where of $1 does not tell"
  done
  grep -q "$2" "$1/latest/records.jsonl" || failed "finer steps" "$1: no $2"
}
holds 0 "a case takes finer steps" "$validate" --case incline/below/stop/point --configuration quiet --finer 16 --out finer_case
finer finer_case '"differs":{"finer":"16"}'
holds 0 "a problem takes finer steps" "$validate" "$example" --finer 16 --out finer_problem
finer finer_problem '"dt":"1.25e-05"'
holds 0 "another engine takes finer steps" "$validate" --engine plain --case incline/below/stop/point --finer 16 --out finer_plain
finer finer_plain '"finer":"16"'
holds 0 "a perturbed case takes finer steps" \
  "$validate" --case incline/below/stop/point --configuration quiet --perturb turned/1 --finer 16 --out finer_turned
finer finer_turned '"dt":"1.25e-05"'
holds 0 "a look at a problem tells its finer steps" "$validate" "$example" --finer 16 --check-only --out look
grep -q 'steps of 0.0125 ms' out || failed "a look at a problem" "it tells other steps: $(cat out)"

# ---- exit code 2: what cannot run -------------------------------------------------------------
refuses "an unknown case" "no case matches 'nonsense/*'; --list shows them all" \
  "$validate" --case 'nonsense/*'
# ---- another engine ---------------------------------------------------------------------------
holds 0 "an engine of rigid bodies passes what it can" "$validate" --engine plain --no-page --out plain
grep -q '^0 fail, 0 broke off · .* · 0 fall short as expected · .*[1-9][0-9]* not applicable' out ||
  failed "an engine of rigid bodies" "something else than pass and not applicable: $(tail -n 3 out)"
grep -q '"the engine has no bodies given as meshes, held parts, contact between bodies"' plain/latest/records.jsonl ||
  failed "an engine of rigid bodies" "no words for what it lacks"
holds 1 "the same engine creeping fails" "$validate" --engine plain --set creep=1e-3 --no-page --out creeping
for red in incline/below/creep/50% incline/below/creep/99% incline/restick/point incline/threshold/mu=0.5/azimuth=30/yaw=20; do
  grep -q "\"case\":\"$red\".*\"verdict\":\"fail\"" creeping/latest/records.jsonl ||
    failed "the same engine creeping fails" "$red does not"
done
refuses "an unknown engine" "unknown engine 'magic'; there are: plain, stiction" "$validate" --engine magic
refuses "an unknown setting" "engine 'stiction' has no setting 'sped'; there are: alpha" \
  "$validate" --set sped=3
refuses "a setting that is no number" "setting 'dt' needs a finite number, not 'fast'" \
  "$validate" --set dt=fast
refuses "a setting without a value" "--set needs NAME=VALUE, not 'dt'" "$validate" --set dt
refuses "--lines with --verbose" "--lines and --verbose exclude each other" "$validate" --quick --lines --verbose
holds 2 "a time that is no number" "$validate" --max-seconds nan
grep -qF "must be a finite number above 0, not 'nan'" err || failed "a time that is no number" "no sentence says so"
holds 2 "no steps at all" "$validate" --finer 0
refuses "--quick with --full" "--quick and --full exclude each other" "$validate" --quick --full
refuses "a missing problem" "cannot read 'missing.toml'" "$validate" missing.toml
refuses "a report folder that cannot be" "/dev/null/reports" \
  "$validate" --case half-space/free-fall --out /dev/null/reports
holds 2 "an unknown option" "$validate" --bogus
grep -q -- --bogus err || failed "an unknown option" "stderr does not name it"
holds 2 "no jobs at all" "$validate" --jobs 0
refuses "a time step above the limit" \
  "the time step 0.01 s is above the stability limit 0.000352344 s, set by tetrahedron 1 (body 'box')" \
  "$validate" --case half-space/rest --set dt=0.01
refuses "an unknown friction rule" "unknown friction rule 'magic'; there are: " \
  "$validate" --case half-space/bounce --set rule=magic

refuses "a parameter out of its range" "rule 'conjugate-vector': 'slip-tolerance' must be at least 0, not -3" \
  "$validate" --quick --set slip-tolerance=-3 --out ranges
[ ! -e ranges ] || failed "a parameter out of its range" "it made a report folder"
refuses "a parameter of another rule" "rule 'none' has no parameter 'gain'; it has none" \
  "$validate" --case half-space/bounce --set rule=none --set gain=0.6

# problem NAME SED_SCRIPT: a problem of one's own with a mistake in it.
cat >good.toml <<'TOML'
duration = 0.1
[engine]
dt = 2e-4
[[obstacle]]
name = "ramp"
slope_deg = 20
friction = 0.5
[[body]]
name = "box"
shape = "box"
size = [0.2, 0.2, 0.1]
mass = 1.0
rests_on = "ramp"
[[check]]
observable = "contacts"
expected = 9
tolerance = 0
reason = "3 × 3 vertices of the lower face"
TOML
problem() {
  sed "$2" good.toml >"$1.toml"
  ! cmp -s good.toml "$1.toml" || failed "$1.toml" "has no mistake"
}
problem broken 's/mass = 1.0/mass = 1.0 kg/'
refuses "a problem that is not TOML" "broken.toml:12: " "$validate" broken.toml
problem unknown_key 's/friction = 0.5/frction = 0.5/'
refuses "a misspelt key" "unknown_key.toml:4: [[obstacle]] lacks 'friction'" \
  "$validate" unknown_key.toml
problem nan 's/friction = 0.5/friction = nan/'
refuses "NaN" "nan.toml:7: 'friction' must be a finite number" "$validate" nan.toml
problem negative_mass 's/mass = 1.0/mass = -1.0/'
refuses "a negative mass" "negative_mass.toml:12: 'mass' must be positive" "$validate" negative_mass.toml
problem negative_friction 's/friction = 0.5/friction = -0.5/'
refuses "a negative μ" \
  "'friction' must not be negative" \
  "$validate" negative_friction.toml
problem long_step 's/dt = 2e-4/dt = 1e-2/'
refuses "a problem's time step above the limit" "is above the stability limit" \
  "$validate" long_step.toml
tr -s ' \n' ' ' <out | grep -qE "limit 0\.00[0-9]+ s, set by tetrahedron [0-9]+ \(body 'box'\)" ||
  failed "a problem's time step above the limit" "limit and element are not named"
problem inside 's/rests_on = "ramp"/position = [0, 0, 0]/'
refuses "a box inside the plane" "m inside obstacle 'ramp'" "$validate" inside.toml
mesh_of() { # mesh_of NAME TETRAHEDRA: a tetrahedron of one's own above the ramp
  cat >"$1.toml" <<TOML
duration = 0.01
[[body]]
name = "tet"
shape = "mesh"
vertices = [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1], [0.1, 0.1, 0]]
tetrahedra = $2
mass = 1
position = [0, 0, 1]
[[check]]
observable = "speed"
expected = 0.0981
tolerance = 1e-12
reason = "free fall for 0.01 s, g t"
TOML
}
mesh_of tet '[[0, 1, 2, 3], [1, 4, 2, 3]]'
holds 0 "a mesh of one's own falls" "$validate" tet.toml
mesh_of inverted '[[0, 2, 1, 3], [1, 4, 2, 3]]'
refuses "an inverted tetrahedron" "body 'tet': tetrahedron 0 is inverted" "$validate" inverted.toml
mesh_of flat_tet '[[0, 1, 2, 3], [1, 4, 2, 0]]'
refuses "a tetrahedron of zero volume" "body 'tet': tetrahedron 1 is flat" "$validate" flat_tet.toml
mesh_of beyond '[[0, 1, 2, 3], [1, 4, 2, 9]]'
refuses "an index out of range" "there is no vertex 9; there are 5, counted from 0" \
  "$validate" beyond.toml
problem flat 's/size = .*/size = [0.2, 0.2, 0.0]/'
refuses "a box without height" "a box needs three positive edges" \
  "$validate" flat.toml
problem negative_stiffness 's/mass = 1.0/mass = 1.0\nyoungs_modulus = -1/'
refuses "a negative stiffness" "negative_stiffness.toml:13: 'youngs_modulus' must be positive" \
  "$validate" negative_stiffness.toml

# ---- a closed surface, which mesh_surface fills ------------------------------------------------
# cube FACES: a cube of 200 mm with the origin in its middle.
cube() {
  printf '%s\n' OFF "8 $1 0" '-100 -100 -100' '100 -100 -100' '-100 100 -100' '100 100 -100' \
    '-100 -100 100' '100 -100 100' '-100 100 100' '100 100 100' >cube.off
  printf '3 %s\n' '0 2 1' '1 2 3' '4 5 6' '5 7 6' '0 1 4' '1 5 4' '2 6 3' '3 6 7' '0 4 2' '2 4 6' \
    '1 3 5' '3 7 5' | head -n "$1" >>cube.off
}
mesh_of surface '[]'
sed -i 's/^shape = .*/shape = "surface"\nfile = "cube.off"\nscale = 1e-3\ncell_size = 0.2/
  /^vertices\|^tetrahedra/d' surface.toml
cube 12
holds 0 "a cube from a surface file falls" "$validate" surface.toml --out surface
grep -q '"meshes":\[{[^]]*"tetrahedra":[1-9]' surface/latest/records.jsonl ||
  failed "a cube from a surface file falls" "no tetrahedra in its record"
cube 11
refuses "an open surface" "surface.toml:5: cube.off: it is not closed: some edges have one triangle only" \
  "$validate" surface.toml
printf 'ply\nformat ascii 1.0\nproperty float x\nend_header\n0\n' >crash.ply
sed 's/cube.off/crash.ply/' surface.toml >crash.toml
refuses "a file that CGAL's reader falls over" "crash.toml:5: crash.ply: it can't be read as ply" "$validate" crash.toml
printf 'OFF\n300000000 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >huge.off
sed 's/cube.off/huge.off/' surface.toml >huge.toml
refuses "a file of 44 bytes with 300 million vertices" \
  "huge.toml:5: huge.off: it says that it has 300000000 vertices, which its 44 bytes cannot hold" "$validate" huge.toml
cube 12
sed 's/cell_size = .*/cell_size = 0.001/' surface.toml >fine.toml
refuses "a mesh that would be too large" \
  "fine.toml:7: cube.off: it would take about 40 million tetrahedra, more than the 200 000 of most_tetrahedra: choose a cell_size of 0.0059 m or more" \
  timeout 20 "$validate" fine.toml
sed -E 's/^([-0-9]+ [-0-9]+ -?)100$/\10.5/' cube.off >plate.off # 1 mm
sed 's/cube.off/plate.off/' surface.toml >plate.toml
refuses "a thin plate" "tetrahedra: it is about 0.00099 m thin, which no cell_size helps" timeout 20 "$validate" plate.toml
sed 's/cell_size = .*/most_tetrahedra = 0/' surface.toml >none.toml
refuses "no tetrahedra at all" "none.toml:7: 'most_tetrahedra' must lie between 1 and 1e9" "$validate" none.toml

# A mesher that takes its time: where it is no terminal, one line tells of it.
printf '#!/bin/sh\necho expected 40 0.2 >&2\nsleep 4\nexec %s/mesh_surface "$@"\n' "$build" >slow_mesher
chmod +x slow_mesher
holds 0 "meshing that takes long" env STICTION_MESHER="$work/slow_mesher" XDG_CACHE_HOME="$work/other" "$validate" surface.toml --list
[ "$(cat err)" = "meshing cube.off: about 40 tetrahedra" ] || failed "meshing that takes long" "it is not told in one line"
sed 's/cell_size = .*/time_limit = 0.5/' surface.toml >hurry.toml
sed 's/^sleep.*/exec sleep 60/' slow_mesher >stuck_mesher
chmod +x stuck_mesher
refuses "meshing that takes longer than it may" \
  "cube.off: the mesher was stopped after 0.5 s: choose a larger cell_size, such as 0.0004 m, or raise time_limit" \
  env STICTION_MESHER="$work/stuck_mesher" "$validate" hurry.toml

# ---- meshes are remembered --------------------------------------------------------------------
kept=("$XDG_CACHE_HOME"/stiction/meshes/*.mesh)
[ ${#kept[@]} -eq 1 ] || failed "a mesh is remembered" "not one but: ${kept[*]}"
hash_of() { grep -o '"state_hash":"[^"]*"' "$1/latest/records.jsonl"; }
for state in whole "cut off" empty; do
  [ "$state" != "cut off" ] || truncate -s -9 "${kept[0]}"
  [ "$state" != empty ] || : >"${kept[0]}"
  exits 0 "with a $state memory of it" "$validate" surface.toml --out remembered
  [ "$(hash_of remembered)" = "$(hash_of surface)" ] || failed "with a $state memory of it" "the state is another"
done
[ -s "${kept[0]}" ] || failed "a damaged memory" "it is not made anew"
passed "a mesh is remembered, and made anew where its memory is damaged"
rm cube.off
refuses "a missing surface" "surface.toml:5: cube.off: there is no such file" "$validate" surface.toml
cube 12
mkdir alone
cp "$validate" alone/
missing="surface.toml:5: cube.off: the mesher is not built: 'cmake --build BUILD_FOLDER --target mesh_surface' does it"
refuses "a surface without the mesher" "$missing" env -u STICTION_SCRIPT alone/validate surface.toml
exits 2 "… beside another problem" env -u STICTION_SCRIPT alone/validate surface.toml tet.toml --out beside
[ "$(grep -c '"verdict":"pass"' beside/latest/records.jsonl)" -eq 1 ] ||
  failed "… beside another problem" "which doesn't run"
passed "… beside another problem, which runs"
cat >builder <<'SH'
#!/bin/sh
[ "$*" = mesher ] && echo "building" >&2 && cp "$BUILT" "$(dirname "$0")/alone/"
SH
chmod +x builder
holds 0 "the mesher is built when it is first called for" \
  env STICTION_SCRIPT="$work/builder" BUILT="$build/mesh_surface" alone/validate surface.toml
grep -q building err || failed "the mesher is built when it is first called for" "nobody is told"

# ---- two runs into one folder -----------------------------------------------------------------
exits 0 "a first run" "$validate" --case half-space/free-fall --out twice
first=$(readlink twice/latest)
exits 0 "a second run" "$validate" --case half-space/bounce --out twice
second=$(readlink twice/latest)
[ "$first" != "$second" ] || failed "two runs into one folder" "latest did not move"
[ "$(find twice -mindepth 1 -maxdepth 1 -type d | wc -l)" -eq 2 ] ||
  failed "two runs into one folder" "not two folders"
for run in "$first" "$second"; do
  for file in records.jsonl report.md junit.xml records.csv; do
    [ -s "twice/$run/$file" ] || failed "two runs into one folder" "$run lacks $file"
  done
  [ "$(wc -l <"twice/$run/records.jsonl")" -eq 1 ] ||
    failed "two runs into one folder" "records of $run got mixed"
done
grep -q half-space/bounce "twice/latest/records.jsonl" ||
  failed "two runs into one folder" "latest is not the last"
passed "two runs into one folder do not mix, and latest is the last"

# ---- a full disk ------------------------------------------------------------------------------
# The first record fits below the file size limit, the second does not.
cases=(--case half-space/free-fall --case incline/above/acceleration/box --jobs 1)
exits 0 "before the disk is full" "$validate" "${cases[@]}" --out roomy
kib=$(($(head -n 1 roomy/latest/records.jsonl | wc -c) / 1024 + 1))
[ "$(wc -c <roomy/latest/records.jsonl)" -gt $((kib * 1024)) ] ||
  failed "a full disk" "the second record is too small to show it"
limited() ( # stdout through a pipe, which has no size
  ulimit -f "$kib"
  set -o pipefail
  "$validate" "${cases[@]}" --out full | cat
)
refuses "a full disk" "records.jsonl" limited
records=$(find full -name records.jsonl)
if [ "$(wc -l <"$records")" -ne 1 ] || [ -n "$(tail -c 1 "$records")" ]; then
  failed "a full disk" "not the one complete record"
fi
grep -qE '^\{.*"case":"half-space/free-fall".*\}$' "$records" ||
  failed "a full disk" "the finished record cannot be read"
passed "a full disk loses no finished record"

# ---- recordings ---------------------------------------------------------------------------------
recorded=(--case incline/restick/box --set rule=none)
STICTION_RUN_FILE=$work/run exits 0 "a recorded case" "$validate" "${recorded[@]}" --out frames --vtk
run=$(cat run)
[ -s "$run/$(sed -E 's/.*"frames":"([^"]+)".*/\1/' "$run/records.jsonl")" ] ||
  failed "a recorded case" "its record names no file in $run"
[ -s "$run/vtk/000-incline_restick_box.pvd" ] || failed "--vtk" "there is no PVD file"
exits 0 "a case by itself" "$validate" --case half-space/free-fall --out unrecorded --no-page
[ ! -e unrecorded/latest/frames ] || failed "recordings" "a case that asks for none has one"
passed "a case that asks is recorded, with --vtk for ParaView too"

# ---- determinism ------------------------------------------------------------------------------
exits 0 "one job at a time" "$validate" --quick --jobs 1 --out jobs1
state_hashes jobs1 >out
state_hashes quick >err
grep -qvE ' [0-9a-f]{16}$' out && failed "state hashes" "a record has none"
[ "$(wc -l <out)" -ge 8 ] || failed "state hashes" "too few records to tell"
cmp -s out err || failed "state hashes" "--jobs 1 and --jobs 2 differ"
passed "the same $(wc -l <out) state hashes with --jobs 1 and --jobs 2"

# ---- what is expected to fall short -------------------------------------------------------------
short=(--case slab/rest/one --no-page)
holds 0 "what falls short as expected doesn't fail" "$validate" "${short[@]}" --verbose --out short
grep -q '^  refuted  *mean contact slip' out || failed "a refuted claim" "the table has none"
grep -q 'as expected in \[' out || failed "a refuted claim" "its band is not shown"
grep -q '^0 fail, 0 broke off · 1 hold · 2 fall short as expected' out || failed "a refuted claim" "it is not counted"
grep -q '"band":\[' short/latest/records.jsonl || failed "a refuted claim" "no band in its record"
exits 1 "far worse than expected" "$build/validate_friction_sign" "${short[@]}" --out worse
grep -q 'worse than expected \[' out || failed "far worse than expected" "no sentence says so"
passed "a method that falls far shorter than expected turns the case red"
exits 1 "better than known" "$build/validate_better_than_known" "${short[@]}" --out better
grep -q 'better than known \[.*raise the bar' out || failed "better than known" "no sentence says so"
passed "a method that is better than known turns the case red until its band is drawn anew"
exits 1 "settings of one's own" "$validate" "${short[@]}" --set method=paper --set gain=0.6 --out own
! grep -q 'expected in \|than expected\|than known' out || failed "settings of one's own" "a band holds"
grep -qF 'with --set no shortfall is expected' err || failed "settings of one's own" "no sentence says why"
exits 1 "a tolerance of one's own" "$validate" "${short[@]}" --tolerance-scale 2 --out own
! grep -q 'expected in \|than expected\|than known' out || failed "a tolerance of one's own" "a band holds"
passed "bands hold for the catalog's variants and tolerances only"
exits 0 "--show-expectations" "$validate" --show-expectations short/latest/records.jsonl
grep -qF '{"slab/rest/one", "method=paper", "mean contact slip", {' out ||
  failed "--show-expectations" "a row is missing"
grep -q '// inside: ' out || failed "--show-expectations" "no value is shown"
exits 0 "--show-expectations" "$validate" --show-expectations worse/latest/records.jsonl
grep -q '// OUTSIDE \[' out || failed "--show-expectations" "no band is proposed"
passed "--show-expectations writes the table's rows, with a band where one has to move"

# ---- planted faults turn named cases red ------------------------------------------------------
bites() { # bites MUTATION CASE [OPTION …]
  local mutation=$1 name=$2
  shift 2
  exits 0 "the correct program on $name" "$validate" --case "$name" --out correct "$@"
  exits 1 "$mutation on $name" "$build/validate_$mutation" --case "$name" --out mutated "$@"
  grep -q '^  FAIL' out || failed "$mutation on $name" "no check fails"
  passed "$mutation turns $name red"
}
bites friction_scaled 'incline/threshold/mu=0.3/azimuth=30/yaw=0'
bites friction_scaled incline/above/acceleration/box
bites friction_scaled incline/below/stop/point
bites friction_sign incline/below/creep/99%
bites friction_sign incline/below/stop/point
bites friction_sign incline/restick/box
bites stale_memory incline/below/creep/99% --set rule=fixed-point
bites stale_memory incline/restick/box --set rule=fixed-point
bites stale_memory incline/below/creep/90% --set rule=fixed-point
for mutation in friction_scaled friction_sign stale_memory; do
  holds 0 "$mutation leaves a free fall alone" \
    "$build/validate_$mutation" --case half-space/free-fall --out unharmed
done
