% First contact: S1002 on 60E1, the wheelset 5 mm to the left.
r = wrc_solve ('pose.lateral', 5, 'track.rail', '60E1', 'wheelset.wheel', 'S1002');
printf ('left wheel: %.1f MPa over %.2f mm2\n', r.left.pmax, r.left.area);
printf ('warning: %s\n', r.warnings{:});
wrc_plot (r, 'first_contact.png')
