function result = wrc_solve (varargin)
% WRC_SOLVE  Contact points, pressures and forces of wheels on rails.
%
%   r = wrc_solve (key, value, ...)
%   r = wrc_solve (scene, key, value, ...)
%
%   Solves a scene: contact points, patches, pressures and forces of both wheels. Keys that are
%   not given have the values of the default scene (S1002 on 60E1 inclined 1:40, 80 kN a wheel).
%   wrc_keys lists the keys with their ranges. A scene is a struct, in which scene.pose.lateral is
%   the key 'pose.lateral'; pairs after it override its values.
%
%   Values are numbers, lists of numbers or texts, as in scene files. A profile ('track.rail',
%   'wheelset.left.wheel', ...) is a name, a file, or points: a matrix of two columns, lateral and
%   height in mm. Its options are keys behind it: 'track.rail.smoothing', or scene.track.rail.file
%   and scene.track.rail.smoothing of a struct.
%
%   An array of scenes is solved on 'threads' threads (1 by default); r is an array too, the same
%   for any number of threads. r(k).status is 'ok' or the kind of failure, and r(k).message gives
%   the reason. A single scene that fails raises an error.
%
%   Results are those of docs/results.md: r.left.pmax, r.left.patches(1).grid.lateral for
%   left.patches.0.grid.lateral. Fields of patches are matrices whose columns go along x, the
%   direction of driving: r.left.patches(1).fields.pressure. 'fields' names the fields to return,
%   separated by blanks; by default 'x y z pressure' and tractions. Derivatives of a number are in a
%   field next to it: spin_moment_by.friction. Sensitivities are not returned.
%
%   Units: mm, N, MPa, rad. Frame: x forward, y to the left, z up; forces act on the wheel.
%
%   Errors have identifiers by their kind: wrcontact:unknown_name, :invalid_argument, :no_contact,
%   :file_unreadable, :file_malformed, :out_of_memory. Results that miss the accuracy come with the
%   warning wrcontact:not_converged.
%
%   Doubtful profiles or solutions raise warnings, whose identifiers are their classes in
%   docs/warnings.md: warning ('off', 'wrcontact:patch_turn') silences one. r.warnings has the
%   texts, r.warning_classes the classes, r.warning_grades the grades, r.grade the worst (0 fine,
%   1 a little over the accuracy, 2 do not use). Those a little over are one warning,
%   wrcontact:a_little_over. Many scenes raise each class once, with the number of scenes that
%   have it.
%
%   Example:
%     r = wrc_solve ('pose.lateral', 5);
%     wrc_plot (r)
%     scenes = struct ('pose', num2cell (struct ('lateral', num2cell (-6:0.5:6))));
%     r = wrc_solve (scenes, 'track.rail', '56E1', 'threads', 2);
%     plot (-6:0.5:6, arrayfun (@(one) one.left.pmax, r))
%
%   See also wrc_keys, wrc_plot, wrc_step, wrc_normal, wrc_rolling, wrc_profile.
  result = wrc_mex ('solve', varargin{:});
end
