% Tests of the functions in octave_bindings; run_tests.m runs them. Values are those of the same calls
% in C (reference.c) in all bits.

%!function bits = expected (name)
%!  global reference
%!  lines = regexp (reference, ['^' name ' (\w{16})$'], 'tokens', 'lineanchors');
%!  bits = vertcat (cellfun (@(line) line{1}, lines, 'uniformoutput', false){:});
%!endfunction

%!test <*every number of a scene>
%! global reference
%! r = wrc_solve ('pose.lateral', 5, 'solve.creep', 'full', 'creepage.left', [1e-3 5e-4 2e-4]);
%! lines = regexp (reference, '^(\w[^ ]*) (\w{16})$', 'tokens', 'lineanchors');
%! compared = 0;
%! for k = 1:numel (lines)
%!   name = lines{k}{1};
%!   if (isempty (strfind (name, 'sensitivities')) && isempty (strfind (name, 'time_ms')))
%!     place = regexprep (strrep (name, '.by.', '_by.'), '\.(\d+)', '($1+1)');
%!     value = eval (['r.' place]);
%!     assert (num2hex (value), lines{k}{2}, name);
%!     ++compared;
%!   endif
%! endfor
%! assert (compared > 150);
%! p = r.left.patches(1);
%! assert (size (p.fields.pressure), [p.grid.longitudinal, p.grid.lateral]);
%! assert (num2hex (p.fields.pressure(:)), expected ('=pressure'));
%! assert (size (p.fields.traction_x), [p.creep_grid.longitudinal, p.creep_grid.lateral]);
%! assert (any (p.fields.traction_x(:) < 0));
%! assert (all (diff (p.fields.x(:, 1)) > 0)); # columns go forwards
%! assert (r.left.stop_reason, 'tolerance_met');
%! assert (iscell (r.left.warnings) && ischar (r.left.warnings{1}));
%! assert (numel (r.left.rail_y), numel (r.left.rail_z));

%!test <*struct, pairs and both>
%! scene.pose.lateral = 3;
%! scene.track.rail = '54E1';
%! scene.solve.side = 'left';
%! first = wrc_solve (scene);
%! assert (wrc_solve (scene, 'pose.lateral', 2).left.pmax != first.left.pmax);
%! same = wrc_solve ('pose.lateral', 3, 'track.rail', '54E1', 'solve.side', 'left');
%! assert (same.left.pmax, first.left.pmax);
%! assert (! isfield (first, 'right'));
%! # options of a profile count wherever they stand in a struct
%! before.track.rail = struct ('origin', 750, 'file', '54E1');
%! after.track.rail = struct ('file', '54E1', 'origin', 750);
%! moved = wrc_solve (before, 'pose.lateral', 3, 'solve.side', 'left');
%! assert (moved.left.pmax, wrc_solve (after, 'pose.lateral', 3, 'solve.side', 'left').left.pmax);
%! assert (moved.left.pmax != first.left.pmax);
%! # two lobes that share a plane
%! lobes = wrc_solve ('track.rail', 'UIC60-Manchester', 'solve.side', 'right', 'pose.lateral', -5, ...
%!                    'pose.roll', 0, 'load.both', 1e4);
%! parts = lobes.right.patches(1).parts;
%! vertical = arrayfun (@(part) part.pressure_force.z, parts);
%! assert (sum (vertical), lobes.right.patches(1).pressure_force.z, -1e-9);
%! assert (size (parts(2).fields.pressure), [parts(2).grid.longitudinal, parts(2).grid.lateral]);
%! none = wrc_solve (scene, 'fields', '');
%! assert (isfield (none.left, 'patches') && ! isfield (none.left.patches, 'fields'));
%! gaps = wrc_solve (scene, 'fields', 'undeformed_distance displacement');
%! assert (sort (fieldnames (gaps.left.patches(1).fields)), {'displacement'; 'undeformed_distance'});

%!test <*many scenes on threads, one of which fails>
%! lateral = [-4 0 3 100 5];
%! scenes = struct ('pose', num2cell (struct ('lateral', num2cell (lateral))));
%! one = wrc_solve (scenes, 'solve.accuracy', 1e-2);
%! two = wrc_solve (scenes, 'solve.accuracy', 1e-2, 'threads', 2);
%! assert ({one.status}, {'ok', 'ok', 'ok', 'no contact', 'ok'});
%! assert (isempty (one(4).left) && ! isempty (one(4).message));
%! for k = [1 2 3 5]
%!   alone = wrc_solve ('pose.lateral', lateral(k), 'solve.accuracy', 1e-2);
%!   assert ([one(k).left.pmax, two(k).left.pmax], [1 1] * alone.left.pmax);
%! endfor

%!test <*points of a profile>
%! p = wrc_profile ('60E1', 4000);
%! assert (p.kind, 'rail');
%! assert (numel (p.lateral), 4000);
%! by_name = wrc_solve ('track.rail', '60E1', 'solve.side', 'left');
%! points = [p.lateral, p.height];
%! by_points = wrc_solve ('track.rail', points, 'solve.side', 'left');
%! # points 0.04 mm apart on the curve stand for it to the accuracy asked, 1e-3
%! assert (by_points.left.pmax, by_name.left.pmax, -1e-3);
%! assert (by_points.left.pmax != by_name.left.pmax);
%! wheel = wrc_profile ('S1002');
%! assert (wheel.kind, 'wheel');
%! assert (interp1 (wheel.lateral, wheel.height, 0), 0, 1e-3); # taping line

%!test <*steps of a vehicle>
%! w = wrc_step ('open', 'solve.creep', 'fastsim');
%! position = [0, 3, 459.9, 0, 0, 1e-3];
%! velocity = [20000, 10, 0, 0, 43.5, 0];
%! rails = [0.1, 0, 0, -0.1, 0, 0];
%! [force, state, by_position, by_velocity] = wrc_step (w, position, velocity, rails);
%! assert (num2hex (force(:)), expected ('=force'));
%! assert (num2hex (by_position(:)), expected ('=by_position'));
%! assert (num2hex (by_velocity(:)), expected ('=by_velocity'));
%! assert (size (by_position), [6 6 2]);
%! assert (size (state), [1 2]);
%! r = wrc_step ('results', w);
%! assert (r.left.total.force.z, force(3, 1));
%! h = zeros (1, 4); % an array of doubles, of four wheelsets
%! h(1) = w;
%! h(4) = wrc_step ('open', 'solve.creep', 'fastsim');
%! assert (wrc_step (h(4), position, velocity, rails), force);
%! assert (wrc_step (h(1), position, velocity, rails), force);
%! wrc_step ('close', h(4));
%! wrc_step ('close', w);
%! w = wrc_step ('open', 'precision', 'double', 'planner', 'estimate', 'solve.creep', 'fastsim');
%! assert (wrc_step (w, position, velocity, rails), force, 1e-6 * max (abs (force(:))));
%! wrc_step ('close', w);
%! fail ('wrc_step (w, position, velocity)', 'that has not been closed');
%! left_open = wrc_step ('open');
%! clear wrc_mex
%! fail ('wrc_step (left_open, position, velocity)', 'that has not been closed');

%!test <*contacts on grids>
%! [x, y] = ndgrid ((-11.5:11.5) / 2, (-15.5:15.5) / 2);
%! n = wrc_normal ((2 * x .^ 2 + y .^ 2) / 1024, [0.5 0.5], 'normal_load', 8e4);
%! assert (num2hex (n.pressure(:)), expected ('=normal'));
%! assert (sum (n.pressure(:)) * 0.25, 8e4, -1e-12);
%! q = wrc_rolling (n.pressure, [0.5 0.5], 'model', 'fastsim', 'longitudinal_creepage', 1e-3);
%! assert (num2hex (q.traction_x(:)), expected ('=rolling'));
%! assert (q.creep_force.longitudinal < 0);

%!test <*errors have the text of the library and the status as identifier>
%! file = [tempname(), '.txt'];
%! closing = onCleanup (@() delete (file));
%! fputs (stream = fopen (file, 'w'), 'no profile');
%! fclose (stream);
%! rail = wrc_profile ('60E1');
%! points = [rail.lateral, rail.height];
%! cases = {{'pose.latera', 5}, 'unknown_name', 'nearest: pose.lateral;';
%!          {'pose.lateral', 2e4}, 'invalid_argument', 'pose.lateral = 20000: must be between -1e4 and 1e4 mm';
%!          {'pose.lateral', 100}, 'no_contact', 'wheel off the rail';
%!          {'track.rail', 'no/such.txt'}, 'unknown_name', 'no/such.txt';
%!          {'track.rail', file}, 'file_malformed', file;
%!          {'pose.lateral'}, 'invalid_argument', 'a value is missing';
%!          {'pose.lateral', {5}}, 'invalid_argument', 'must be real numbers';
%!          {'pose.lateral', 5i}, 'invalid_argument', 'must be real numbers';
%!          {5}, 'invalid_argument', 'must be a text';
%!          {'threads', 0}, 'invalid_argument', 'threads';
%!          {'threads', NaN}, 'invalid_argument', 'threads';
%!          {'track.rail', [1 2; 3 4; 5 6]}, 'invalid_argument', '3 points';
%!          {'wheel', points}, 'unknown_name', 'unknown key wheel';
%!          {'pose.lateral', points}, 'invalid_argument', 'a rail for track.rail'};
%! for k = 1:rows (cases)
%!   caught = [];
%!   try
%!     wrc_solve (cases{k, 1}{:});
%!   catch caught
%!   end_try_catch
%!   assert (! isempty (caught), cases{k, 2});
%!   assert (caught.identifier, ['wrcontact:', cases{k, 2}]);
%!   assert (! isempty (strfind (caught.message, cases{k, 3})), caught.message);
%! endfor
%! fail ("wrc_normal ([1 2; 3 4], [1 -1])", 'step');
%! fail ("wrc_rolling ([1 2; 3 4], [1 1], 'no_key', 1)", 'no_key');
%! fail ("wrc_profile ('no/such.txt')", 'no/such.txt');
%! [~, identifier] = lasterr ();
%! assert (identifier, 'wrcontact:file_unreadable');
%! fail ("wrc_profile ('S1002', 1)", 'points: must be between 2 and 1e7');
%! assert (wrc_solve ().status, 'ok'); # after all of these

%!test <*results that miss the accuracy come with a warning>
%! [x, y] = ndgrid ((-15.5:15.5) / 2);
%! solve = @() wrc_normal ((x .^ 2 + y .^ 2) / 1000, [0.5 0.5], 'maximum_iterations', 1, ...
%!                         'normal_load', 8e4);
%! warning ('off', 'wrcontact:not_converged', 'local');
%! n = solve ();
%! assert (n.stop_reason, 'iteration_limit');
%! assert (any (n.pressure(:) > 0));
%! warning ('error', 'wrcontact:not_converged', 'local');
%! fail ('solve ()', 'not converged');

%!test <*a contact that its grid cuts comes with a warning>
%! [x, y] = ndgrid ((-9.5:9.5) / 2);
%! warning ('off', 'wrcontact:grid_edge', 'local');
%! n = wrc_normal ((x .^ 2 + (y + 3) .^ 2) / 600, [0.5 0.5], 'normal_load', 2e4);
%! assert (n.warning_classes, {'grid_edge'});
%! assert (strncmp (n.warnings{1}, 'contact reaches the edge', 24));
%! warning ('error', 'wrcontact:grid_edge', 'local');
%! fail ("wrc_normal ((x .^ 2 + (y + 3) .^ 2) / 600, [0.5 0.5], 'normal_load', 2e4)", 'contact reaches the edge');

%!test <*a little over the accuracy is a warning of its own>
%! warning ('error', 'wrcontact:a_little_over', 'local');
%! fail ("wrc_solve ('pose.lateral', 5, 'solve.accuracy', 0.004)", 'the rail turns by');

%!test <*keys and help>
%! keys = wrc_keys ('pose.');
%! assert (any (strcmp ({keys.name}, 'pose.lateral')));
%! assert (numel (wrc_keys ()) > numel (keys));
%! printed = evalc ("wrc_keys ('pose.lateral')");
%! assert (strncmp (printed, 'pose.lateral = ', 15));
%! for name = {'solve', 'keys', 'step', 'normal', 'rolling', 'profile', 'plot'}
%!   text = get_help_text (['wrc_' name{1}]);
%!   assert (! isempty (strfind (text, ['WRC_' toupper(name{1})])), name{1});
%! endfor

%!test <*a picture>
%! file = [tempname(), '.png'];
%! closing = onCleanup (@() delete (file));
%! warning ('off', 'all', 'local'); # of the graphics toolkit without a window
%! wrc_plot (wrc_solve ('pose.lateral', 5), file);
%! picture = imread (file);
%! assert (size (picture)(1:2), [760 1000]);
%! colours = unique (reshape (picture, [], 3), 'rows');
%! assert (rows (colours) > 50); # pressures by colour

%!test <*fields> % that there are none of is an error, and so is half a thread
%! fail ("wrc_solve ('fields', 'nonsense')", 'no field is named "left.patches.0.nonsense"');
%! fail ("wrc_solve ('threads', 1.5)", 'whole number');
%! assert (isfield (wrc_solve ('fields', 'pressure stress_xx').left.patches(1), 'fields'));
