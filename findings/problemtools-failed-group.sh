#!/bin/sh
# A test group that fails still scores in problemtools, and how much depends on the order of its cases.
#
# Asked:    two groups of three cases, 10 points a case, and a program that is wrong in one case: how many
#           points?
# Guess:    30: the group with the wrong case fails, and a group that fails scores 0, as subtasks do.
# Seen:     problemtools 1.20260907, `type: scoring`, legacy format: 40 where the wrong case is the group's
#           second, 50 where it is the third: the default grader adds up the cases that were judged, and
#           `on_reject: break` ends a group at its first failure. The table shows WA in place of the group's
#           points, so that its rows do not add up.
# So:       a setter of subtasks writes `grader_flags: min` into each group, with the group's points as
#           accept_score. Then the same program has 10 of 20.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q problemtools==1.20260907 || exit 2
mkdir -p half/data/sample half/data/secret/one half/data/secret/two half/submissions/partially_accepted
printf 'name: Half\ntype: scoring\nlicense: public domain\n' > half/problem.yaml
printf 'on_reject: continue\n' | tee half/data/testdata.yaml > half/data/secret/testdata.yaml
printf 'accept_score: 0\n' > half/data/sample/testdata.yaml
slip=half/submissions/partially_accepted/slip.py
case=0
for at in sample/1 secret/one/1 secret/one/2 secret/one/3 secret/two/1 secret/two/2 secret/two/3; do
    echo $((2 * case)) > "half/data/$at.in"
    echo $case > "half/data/$at.ans"
    case=$((case + 1))
done

# Groups and points of a program that is wrong in one case: judged CASE SETTINGS
judged() {
    for group in one two; do printf '%b' "$2" > "half/data/secret/$group/testdata.yaml"; done
    echo "case = int(input()) // 2; print(case if case != $1 else 7)" > "$slip"
    venv/bin/verifyproblem half -p submissions 2>&1 |
        sed -n 's/:[0-9.]*s//g; s/   */ /g; s/^ *slip.py \(.*\) [0-9.]*s$/\1/p'
}

seen=$(
    judged 2 'on_reject: break\naccept_score: 10\n'
    judged 3 'on_reject: break\naccept_score: 10\n'
    judged 3 'on_reject: break\naccept_score: 10\ngrader_flags: min\n'
)
before='AC(0) WA AC(30) 40
AC(0) WA AC(30) 50
AC(0) WA AC(10) 10'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'problemtools-failed-group: as before, a failed group scores 10 or 20 in problemtools 1.20260907'
