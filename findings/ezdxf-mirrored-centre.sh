#!/bin/sh
# A circle of a DXF file that is mirrored keeps its centre in ezdxf, and so do its angles.
#
# Asked:    what is the centre of a circle at (5, 0), and of an arc from 0 to 90 degrees there, mirrored in
#           the y axis?
# Guess:    circle.dxf.center is (-5, 0), and the arc goes from 90 to 180 degrees.
# Seen:     ezdxf 1.4.5: both say (5, 0), the arc 0 to 90 degrees, a polyline's bulge keeps its sign. What
#           changes is `extrusion`, now (0, 0, -1): such entities are in a coordinate system of their own,
#           whose x axis is turned. A LINE is in the world's, and its ends are mirrored.
#           circle.ocs().to_wcs(circle.dxf.center) is (-5, 0), and arc.start_point is right.
# So:       whoever reads circles and lines of a drawing side by side, and mirrored parts are common in
#           drawings, asks ocs().to_wcs() of each, or finds that they do not meet.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv || exit 2
venv/bin/pip install -q ezdxf==1.4.5 numpy==2.4.6 || exit 2
cat > mirror.py <<'PY'
import ezdxf
from ezdxf.math import Matrix44


def plain(point):
    return tuple(round(each) + 0 for each in point)


space = ezdxf.new().modelspace()
circle, arc = space.add_circle((5, 0), 1), space.add_arc((5, 0), 1, 0, 90)
line = space.add_line((5, 0), (6, 0))
bulge = space.add_lwpolyline([(5, 0, 1), (6, 0, 0)], format="xyb")
for each in (circle, arc, line, bulge):
    each.transform(Matrix44.scale(-1, 1, 1))
print(plain(circle.dxf.center), plain(circle.dxf.extrusion), plain(circle.ocs().to_wcs(circle.dxf.center)))
print(plain(arc.dxf.center), round(arc.dxf.start_angle), round(arc.dxf.end_angle), plain(arc.start_point))
print(plain(line.dxf.start), plain(bulge[0]))
PY
seen=$(venv/bin/python mirror.py)
before='(5, 0, 0) (0, 0, -1) (-5, 0, 0)
(5, 0, 0) 0 90 (-6, 0, 0)
(-5, 0, 0) (5, 0, 0, 0, 1)'
if [ "$seen" != "$before" ]; then
    printf '%s has changed: was\n%s\nis now\n%s\n' "$0" "$before" "$seen"
    exit 1
fi
echo 'ezdxf-mirrored-centre: as before, ezdxf 1.4.5 leaves dxf.center at (5, 0)'
