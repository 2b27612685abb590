# Draws what coach --data has written, once or again every second while the run goes on:
#   gnuplot -e "data='coach.dat'; picture='coach.png'" drivers/fortran/coach.gp
#   gnuplot -e "data='coach.dat'; live=1" drivers/fortran/coach.gp
if (!exists('live')) {
  set terminal pngcairo size 1000, 1100 font 'DejaVu Sans,10'
  set output picture
}
# As in drivers/support/gnuplot.cpp.
array colour[4] = ['#0060ad', '#d55e00', '#009e73', '#7030a0']
do for [i=1:4] { set linetype i lc rgb colour[i] }
set border lc rgb '#404040'
set tics out nomirror
set multiplot layout 4, 1
set lmargin 10
set rmargin 32
set key outside right top Left reverse samplen 2 width -2
set grid back lt 1 lw 1 lc rgb '#d8d8d8'
mm = 1e3
kN = 1e-3
set ylabel 'lateral, mm'
plot data using 2:(mm*$3) with lines lc 1 lw 1.5 title 'first wheelset', \
     data using 2:(mm*$4) with lines lc 2 lw 1.5 title 'second wheelset', \
     data using 2:(mm*$7) with lines lc 3 lw 1.5 title 'leading bogie frame', \
     data using 2:(mm*$9) with lines lc 4 lw 1.5 title 'car body', \
     data using 2:(mm*$19) with lines lc 'gray40' title 'alignment'
set ylabel 'wheel load, kN'
plot data using 2:(kN*$11) with lines lc 1 title 'first, left', \
     data using 2:(kN*$12) with lines lc 2 title 'first, right', \
     data using 2:(kN*$13) with lines lc 3 title 'second, left', \
     data using 2:(kN*$14) with lines lc 4 title 'second, right'
set ylabel 'lateral force on the wheel, kN'
plot data using 2:(kN*$15) with lines lc 1 title 'first, left', \
     data using 2:(kN*$16) with lines lc 2 title 'first, right', \
     data using 2:(kN*$17) with lines lc 3 title 'second, left', \
     data using 2:(kN*$18) with lines lc 4 title 'second, right'
set ylabel 'track'
set xlabel 'first wheelset along the track, m'
plot data using 2:(mm*$22) with lines lc 1 lw 1.5 title 'curvature, 1/km', \
     data using 2:(-10*$23) with lines lc 2 lw 1.5 title 'cant, 0.1 rad', \
     data using 2:(mm*($20 + $21)/2) with lines lc 'gray40' title 'height, mm', \
     data using 2:(mm*($20 - $21)) with lines lc 'gray70' title 'left rail above right, mm'
unset multiplot
if (exists('live')) pause 1
if (exists('live')) reread
