#!/usr/bin/env bash
# A real window under Xvfb, driven by xdotool's mouse and keys. What it saves in the end is held against
# what the command line draws of the scene file it saves beside.
#     drive.sh FOLDER_OF_PROGRAMS
set -euo pipefail

programs=$(realpath "$1")
folder=$(mktemp -d)
cd "$folder"
readonly width=800 height=600
options=(teapot --size "${width}x$height")

pids=()
finish() {
    local pid
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
    rm -rf "$folder"
}
trap finish EXIT

fail() { echo "drive: $*" >&2; exit 1; }

# ---- the screen

exec {display}<> <(:)
Xvfb -displayfd "$display" -screen 0 1400x900x24 -nolisten tcp 2>/dev/null &
pids+=($!)
read -r -t 20 -u "$display" number || fail "Xvfb does not start"
export DISPLAY=:$number SDL_VIDEODRIVER=x11

# ---- where the controls stand

declare -A places
read_places() { # OPTIONS...: of what the window shows
    local name x y w h
    while read -r name x y w h; do places[$name]="$x $y $w $h"; done \
        < <("$programs/scanlight-demo" "${options[@]}" "$@" --controls)
}
read_places
((${#places[@]} > 20)) || fail "no controls"

"$programs/scanlight-demo" "${options[@]}" &
demo=$!
pids+=("$demo")
window=$(timeout 20 xdotool search --sync --onlyvisible --name '^Scanlight$' | head -n 1)
[[ -n $window ]] || fail "no window"
sleep 1

# ---- hands

move() { xdotool mousemove --window "$window" "$1" "$2"; sleep 0.15; }
click() { move "$1" "$2"; xdotool mousedown 1; sleep 0.1; xdotool mouseup 1; sleep 0.2; }
drag() { # X Y TO_X TO_Y
    move "$1" "$2"
    xdotool mousedown 1
    sleep 0.15
    move $((($1 + $3) / 2)) $((($2 + $4) / 2))
    move "$3" "$4"
    xdotool mouseup 1
    sleep 0.2
}
key() { xdotool key --window "$window" "$1"; sleep 0.3; }

press() { # CONTROL
    local x y w h
    read -r x y w h <<<"${places[$1]}"
    click $((x + w / 2)) $((y + h / 2))
}
slide() { # CONTROL FROM_PERCENT TO_PERCENT
    local x y w h
    read -r x y w h <<<"${places[$1]}"
    drag $((x + w * $2 / 100)) $((y + h / 2)) $((x + w * $3 / 100)) $((y + h / 2))
}
choose() { # CONTROL NUMBER_OF_WORD
    local x y w h
    read -r x y w h <<<"${places[$1]}"
    press "$1"
    click $((x + 30)) $((y + h + 14 + 20 * $2))
}

saved=0
expect() { # WHAT WORDS...: that the scene file saved now has all these words, and the picture is its
    local what=$1 name=teapot word
    shift
    ((++saved == 1)) || name=teapot-$saved
    press save-picture
    press save-scene
    [[ -s $name.png && -s $name.toml ]] || fail "$what: nothing saved"
    for word; do
        grep -q -- "$word" "$name.toml" || fail "$what: no '$word' in: $(cat "$name.toml")"
    done
    "$programs/scanlight" render "$name.toml" -o expected.png --quiet
    "$programs/scanlight" diff "$name.png" expected.png >/dev/null || fail "$what: another picture"
    echo "drive: $what"
}

# ---- the play

expect "as it opens" 'shape = "teapot"'
drag 100 500 180 470
expect "turned by the mouse" 'eye = \['
move 300 300
xdotool click --window "$window" --repeat 3 --delay 100 4
sleep 0.3
expect "larger by the wheel" 'zoom = 1.331'
choose shading 1
expect "another shading" 'shading = "gouraud"'
choose illumination 3
slide exponent 50 70
expect "another model and exponent" 'illumination = "blinn"' '^n = '
key 3
drag 400 550 250 550
expect "the divider dragged" 'size = \[250, 600\]'
key 1
key f
expect "framed by a key" 'size = \[800, 600\]'
! grep -q 'eye' "teapot-$saved.toml" || fail "framed: the eye is still there"

# ---- the lessons

read_size() { # PNG: its width and height, which stand in its first bytes
    od -An -tu1 -j16 -N8 "$1" | awk '{print $3 * 256 + $4, $7 * 256 + $8}'
}
expect_lesson() { # LESSON PANELS_IN_A_ROW WORDS...: that its saved picture is the command line's
    local name=$1 panels=$2 wide high
    shift 2
    ((++saved_lessons))
    press save-picture
    [[ -s $name.png ]] || fail "$name: nothing saved"
    read -r wide high < <(read_size "$name.png")
    "$programs/scanlight-demo" --lesson "$name" "$@" -s "$((wide / panels))x$high" -o expected.png \
        >/dev/null
    "$programs/scanlight" diff "$name.png" expected.png >/dev/null || fail "$name: another picture"
    rm "$name.png"
    echo "drive: lesson $name $*"
}
saved_lessons=0

press lessons
read -r x y w h <<<"${places[lessons]}"
click $((x + 30)) $((y + h + 14 + 20 * 3))
read_places --window --lesson lost-highlight
key Home
key Right
key Right
expect_lesson lost-highlight 3 --set level=2
press next
press next
read_places --window --lesson perspective
slide azimuth 60 99
expect_lesson perspective 2 --set azimuth=45
press previous
press previous
press previous
press previous
read_places --window --lesson edge-table
read -r x0 y0 _ <<<"${places[corner-0]}"
read -r x1 y1 _ <<<"${places[corner-1]}"
cell=$(((x0 - x1 + 4) / 9)) # that many pixels of the grid are between them
drag "$x1" "$y1" $((x1 + 2 * cell)) $((y1 + cell))
expect_lesson edge-table 1 --set corners=0.1,1.12:-1.3,0.04:-0.1,-1.12:1.6,-0.28
press put-back
expect_lesson edge-table 1
for _ in 1 2 3 4; do press next; done
for _ in 1 2 3; do key Next; done
key End
key Left
expect_lesson phong-terms 4 --set n=80
key Escape
read_places
expect "back to the scene" 'shading = "gouraud"'

# The system's wish to end is heard as the window's own.
kill -TERM "$demo"
wait "$demo" || fail "the window ends with an error"
echo "drive: $saved pictures and $saved_lessons lessons, each the command line's"
