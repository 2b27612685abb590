#!/usr/bin/env bash
# The page of a study in headless Chromium: its slider is moved to the end, and the table must show
# the last scene as wrc_case solves it; and texts that would be elements or scripts are shown as
# texts, there and in a report. Usage: page_in_browser.sh WRC_SWEEP WRC_CASE CHROMIUM [PNG]
# With PNG also takes a picture of the page.
# shellcheck disable=SC2016 # scripts hold ${} of their own
set -euo pipefail
sweep=$1 case=$2 chromium=$3 picture=${4:-}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
options=(--headless --no-sandbox --disable-gpu --hide-scrollbars "--window-size=1150,1100"
  "--user-data-dir=$folder/browser")

cat >"$folder/s.toml" <<'END'
[pose]
lateral = [-2, 0, 4]
[creepage]
longitudinal = 0.001
[solve]
creep = "full"
END
"$sweep" "$folder/s.toml" --out "$folder/s" --page "$folder/page.html" --quiet
# What a hand does.
{
  cat "$folder/page.html"
  echo '<script>
    const slider = document.querySelector("input");
    slider.value = slider.max;
    slider.dispatchEvent(new Event("input"));
    const dot = document.querySelector("#left canvas + canvas").getContext("2d");
    const {data: painted} = dot.getImageData(0, 0, dot.canvas.width, dot.canvas.height);
    document.title = "painted " + painted.filter(value => value > 0).length;
  </script>'
} >"$folder/moved.html"

# shown PAGE: its text of left.pmax, its position, what stands in the title.
shown() {
  "$chromium" "${options[@]}" --dump-dom "file://$folder/$1" 2>"$folder/log" >"$folder/dom"
  grep -oE 'id="left.pmax">[0-9]+|<output>[^<]*|<title>painted [0-9]{4,}' "$folder/dom" | paste -sd ' '
}
# pmax LATERAL
pmax() {
  "$case" --set "pose.lateral=$1" --set creepage.longitudinal=0.001 --set solve.creep=full --json |
    python3 -c 'import json, sys; print(round(json.load(sys.stdin)["left"]["pmax"]))'
}
first=$(shown page.html)
moved=$(shown moved.html)
if [[ $first != "<output>0 mm id=\"left.pmax\">$(pmax 0)" ]] ||
  [[ $moved != "<title>painted "*" <output>4 mm id=\"left.pmax\">$(pmax 4)" ]]; then
  echo "the page shows: $first"
  echo "with its slider moved: $moved"
  exit 1
fi
# Values that differ in the seventh digit have names of their own, which an address finds.
printf '[load]\nboth = [100000, 100000.1, 100000.4]\n[solve]\naccuracy = 0.1\n[study]\ntitle = "at {load.both}"\n' >"$folder/close.toml"
"$sweep" "$folder/close.toml" --out "$folder/close" --page "$folder/close.html" --quiet
"$chromium" "${options[@]}" --dump-dom "file://$folder/close.html#load.both=100000.4%20N" 2>"$folder/log" >"$folder/dom"
if ! grep -qF '<output>100000.4 N</output>' "$folder/dom" || ! grep -qF '<h1 id="title">at 100000.4</h1>' "$folder/dom"; then
  echo "a page of close values shows: $(grep -oE '<h1.*</h1>|<output>[^<]*' "$folder/dom" | paste -sd ' ')"
  exit 1
fi
# Names that begin and end elements and scripts: shown as they are, and nothing of them runs. There are no such
# wheels, so no scene has results, and wrc_sweep ends with 3.
cat >"$folder/names.toml" <<'END'
[wheelset]
wheel = ["evil/<img src=x onerror=document.body.id='ran'><!--\"'</script><script>document.body.id='ran'</scr.txt", "w1/x<script>document.body.id='ran'<b>.txt", "<!-- <script", "=1+1.txt"]
[study]
title = "</script><script>document.body.id='ran'</script> <!-- <script> {pose.yaw}"
END
status=0
"$sweep" "$folder/names.toml" --out "$folder/names" --page "$folder/names.html" --quiet >"$folder/log" 2>&1 || status=$?
if [ "$status" -ne 3 ]; then
  echo "a study without results ends with $status instead of 3:"
  cat "$folder/log"
  exit 1
fi
"$chromium" "${options[@]}" --dump-dom "file://$folder/names.html" 2>"$folder/log" >"$folder/dom"
title="&lt;/script&gt;&lt;script&gt;document.body.id='ran'&lt;/script&gt; &lt;!-- &lt;script&gt; 0"
if ! grep -qF "<h1 id=\"title\">$title</h1>" "$folder/dom" ||
  ! grep -qF '<output>&lt;!-- &lt;script</output>' "$folder/dom" ||
  grep -qE '<body id=|<img' "$folder/dom"; then
  echo "a page with names of elements shows:"
  grep -oE '<body[^>]*>|<h1.*</h1>|<output>.*' "$folder/dom" || true
  exit 1
fi
# Files by name, a scene without contact, values under the pointer, play by the space bar; names are
# not joined by lines, numbers are.
mkdir -p "$folder/a" "$folder/b"
"${sweep%sweep}profile" 60E1 --convert "$folder/a/worn.txt" >"$folder/log" 2>&1
"${sweep%sweep}profile" 54E1 --convert "$folder/b/worn.txt" >"$folder/log" 2>&1
cat >"$folder/rails.toml" <<END
[track]
rail = ["$folder/a/worn.txt", "$folder/b/worn.txt", "60E1"]
[convention]
units = "SI"
[pose]
lateral = [0, 0.003, 0.1]
[solve]
accuracy = 1e-2
END
"$sweep" "$folder/rails.toml" --out "$folder/rails" --page "$folder/rails.html" --quiet
{
  cat "$folder/rails.html"
  echo '<script>
    const report = [], point = (canvas, x, y) => {
      const event = new PointerEvent("pointermove");
      Object.defineProperty(event, "offsetX", {value: x});
      Object.defineProperty(event, "offsetY", {value: y});
      canvas.onpointermove(event);
      return document.getElementById("hover").textContent;
    };
    const course = document.getElementById("course"), pressures = document.querySelectorAll("#left canvas")[1];
    const outputs = () => [...document.querySelectorAll("output")].map(one => one.textContent).join(" at ");
    const chosen = (id, place) => { element(id).selectedIndex = place; element(id).dispatchEvent(new Event("change")); };
    report.push(`over ${element("over").value}`); // of numbers, though names come first
    let joined = 0;
    const lineTo = CanvasRenderingContext2D.prototype.lineTo;
    CanvasRenderingContext2D.prototype.lineTo = function(...place) { ++joined; lineTo.apply(this, place); };
    drawCourse(course);
    report.push(`${joined > 0 ? "lines" : "no lines"}`);
    chosen("over", 0);
    move(0, 1);
    move(1, 0);
    report.push(outputs());
    const {box} = drawPressures(pressures, sceneAt(at).left).view;
    report.push(point(pressures, (box[0] + box[2]) / 2, (box[1] + box[3]) / 2).replace(/-?[0-9]+\.[0-9]+/g, "#").replace(/[0-9]{3,}/, "#"));
    report.push(point(course, course.clientWidth / 2, 100).replace(/[0-9]{3,}/g, "#"));
    move(1, 2);
    report.push(document.getElementById("message").textContent.slice(0, 58), document.getElementById("left.title").textContent);
    document.dispatchEvent(new KeyboardEvent("keydown", {key: " "}));
    report.push(document.querySelector("button").getAttribute("aria-label"));
    document.dispatchEvent(new KeyboardEvent("keydown", {key: " "}));
    move(1, 0);
    joined = 0;
    drawCourse(course);
    report.push(`${joined} lines`);
    document.title = report.join("; ");
  </script>'
} >"$folder/rails_used.html"
"$chromium" "${options[@]}" --dump-dom "file://$folder/rails_used.html" 2>"$folder/log" >"$folder/dom"
expected="over pose.lateral; lines; b/worn.txt at 0 m; y # mm, x # mm: # MPa; b/worn.txt: left #, right #; Not solved: wheel off the rail: no part of the wheel profi; left wheel: no result; stop; 0 lines"
if ! grep -qF "<title>$expected</title>" "$folder/dom"; then
  echo "a page of files shows: $(grep -oE '<title>.*</title>' "$folder/dom")"
  echo "expected: $expected"
  exit 1
fi
# By keys alone, by a click, by the address; scales; a title of the state; nothing wider than 390 px, and colours by night.
cat >"$folder/state.toml" <<'END'
[wheelset]
wheel = ["S1002", "LM"]
[pose]
lateral = [-2, 0, 2, 6]
[solve]
accuracy = 1e-2
[study]
title = "at {pose.lateral} mm, {load.both} N"
END
"$sweep" "$folder/state.toml" --out "$folder/state" --page "$folder/state.html" --quiet >"$folder/log" 2>&1
{
  cat "$folder/state.html"
  echo '<script>
    const report = [], course = element("course"), outputs = () => [...document.querySelectorAll("output")].map(one => one.textContent).join(", ");
    const type = key => course.dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
    course.focus();
    report.push(document.activeElement === course ? "focus" : "no focus", outputs());
    type("End"); type("ArrowLeft");
    report.push(outputs(), document.title, decodeURIComponent(location.hash));
    const study = highest;
    element("scale").selectedIndex = 1;
    element("scale").dispatchEvent(new Event("change"));
    report.push(highest < study ? "own scale" : "same scale");
    const place = drawCourse(course).view.to(-2, 0)[0], click = new MouseEvent("click");
    Object.defineProperties(click, {offsetX: {value: place}, offsetY: {value: 100}});
    course.onclick(click);
    report.push(outputs());
    report.push(`${Math.max(document.documentElement.scrollWidth, document.body.scrollWidth) <= innerWidth ? "fits" : "too wide"} ${innerWidth}`);
    report.push(getComputedStyle(document.body).backgroundColor, ink());
    dispatchEvent(new Event("beforeprint"));
    report.push(ink());
    document.title = report.join("; ");
  </script>'
} >"$folder/state_used.html"
for width in 390 1150; do
  echo "<iframe id=frame width=$width height=2000 src='state_used.html#wheelset.wheel=S1002&pose.lateral=0%20mm'></iframe>
    <script>onload = () => setTimeout(() => { document.title = frame.contentDocument.title; }, 100);</script>" >"$folder/frame.html"
  for night in 1 0; do # 0 is dark
    "$chromium" "${options[@]}" --allow-file-access-from-files "--blink-settings=preferredColorScheme=$night" --virtual-time-budget=5000 \
      --dump-dom "file://$folder/frame.html" 2>"$folder/log" >"$folder/dom"
    colours="rgb(255, 255, 255); #222"
    [ "$night" = 1 ] || colours="rgb(24, 24, 24); #ddd"
    expected="focus; S1002, 0 mm; S1002, 2 mm; at 2 mm, 80000 N; #wheelset.wheel=S1002&amp;pose.lateral=2 mm&amp;show=pmax&amp;over=pose.lateral; own scale; S1002, -2 mm; fits $width; $colours; #222"
    if ! grep -qF "<title>$expected</title>" "$folder/dom"; then
      echo "a page $width pixels wide shows: $(grep -oE '<title>.*</title>' "$folder/dom")"
      echo "expected: $expected"
      exit 1
    fi
  done
done
if grep -oE '(src|href)="?[^" >]+' "$folder/state.html" | grep -v 'data:'; then
  echo "the page asks for another file"
  exit 1
fi
# A report of a wheel with such a name: shown as it is, and all six pictures are there.
hostile="x<img src=x onerror=document.body.id='ran'>.prw"
"${sweep%sweep}profile" S1002 --convert "$folder/$hostile" >"$folder/log" 2>&1
"${sweep%sweep}report" "$folder/$hostile" 60E1 --page "$folder/report.html" --set solve.accuracy=0.1 --quiet
{
  grep -v Content-Security-Policy "$folder/report.html"
  echo '<script>
    onload = () => {
      document.title = [...document.images].filter(image => image.naturalWidth > 300).length + " pictures";
    };
  </script>'
} >"$folder/report_counted.html"
"$chromium" "${options[@]}" --dump-dom "file://$folder/report_counted.html" 2>"$folder/log" >"$folder/dom"
if ! grep -qF "<h1>x&lt;img src=x onerror=document.body.id='ran'&gt;.prw on 60E1</h1>" "$folder/dom" ||
  ! grep -qF "<title>6 pictures</title>" "$folder/dom" || grep -q '<body id=' "$folder/dom"; then
  echo "a report shows:"
  grep -oE '<body[^>]*>|<h1.*</h1>|<title>.*' "$folder/dom" || true
  exit 1
fi
# A report fits a screen of 390 pixels and, as it is printed, the 680 pixels between the margins of A4.
"${sweep%sweep}report" S1002 60E1 --page "$folder/plain.html" --set solve.accuracy=0.1 --nominal-wheel LM --quiet
for width in 390 680; do
  {
    [ "$width" = 390 ] && grep -v Content-Security-Policy "$folder/plain.html"
    [ "$width" = 680 ] && grep -v Content-Security-Policy "$folder/plain.html" | sed 's/@media print/@media all/'
    echo '<script>
      const root = document.documentElement;
      const cut = [...document.querySelectorAll("table, img")].filter(one => one.getBoundingClientRect().right > innerWidth + 1);
      const hidden = innerWidth === 680 ? [...document.querySelectorAll("table")].filter(one => one.scrollWidth > one.clientWidth + 1) : [];
      document.title = `${root.scrollWidth <= innerWidth ? "fits" : "too wide"} ${innerWidth}, ${cut.length + hidden.length} cut`;
    </script>'
  } >"$folder/narrow.html"
  echo "<iframe id=frame width=$width height=2000 src='narrow.html'></iframe>
    <script>onload = () => { document.title = frame.contentDocument.title; };</script>" >"$folder/frame.html"
  "$chromium" "${options[@]}" --allow-file-access-from-files --virtual-time-budget=5000 --dump-dom "file://$folder/frame.html" 2>"$folder/log" >"$folder/dom"
  if ! grep -qF "<title>fits $width, 0 cut</title>" "$folder/dom"; then
    echo "a report $width pixels wide: $(grep -oE '<title>.*</title>' "$folder/dom")"
    exit 1
  fi
done
if [ -n "$picture" ]; then
  "$chromium" "${options[@]}" "--screenshot=$picture" "file://$folder/moved.html" 2>"$folder/log"
fi
