# Draws what bogie --data has written:
#   gnuplot -e "data='bogie.dat'; picture='bogie.png'" drivers/fortran/bogie.gp
set terminal pngcairo size 1000, 900 font 'DejaVu Sans,11'
set output picture
set multiplot layout 3, 1
set lmargin 10
set rmargin 28
set key outside right top Left reverse samplen 2 width -2
set grid
mm = 1e3
kN = 1e-3
set ylabel 'lateral, mm'
plot data using 2:(mm*$3) with lines lc 1 lw 1.5 title 'first wheelset', \
     data using 2:(mm*$5) with lines lc 2 lw 1.5 title 'second wheelset', \
     data using 2:(mm*$7) with lines lc 3 lw 1.5 title 'frame', \
     data using 2:(mm*($16 + $18)/2) with lines lc 'gray40' title 'middle of the rails', \
     data using 2:(mm*($17 - $19)) with lines lc 'gray70' title 'left rail above right'
set ylabel 'wheel load, kN'
plot data using 2:(kN*$8) with lines lc 1 title 'first, left', \
     data using 2:(kN*$9) with lines lc 1 dt 2 title 'first, right', \
     data using 2:(kN*$10) with lines lc 2 title 'second, left', \
     data using 2:(kN*$11) with lines lc 2 dt 2 title 'second, right'
set ylabel 'lateral force on the wheel, kN'
set xlabel 'first wheelset along the track, m'
plot data using 2:(kN*$12) with lines lc 1 title 'first, left', \
     data using 2:(kN*$13) with lines lc 1 dt 2 title 'first, right', \
     data using 2:(kN*$14) with lines lc 2 title 'second, left', \
     data using 2:(kN*$15) with lines lc 2 dt 2 title 'second, right'
unset multiplot
