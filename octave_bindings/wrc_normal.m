function result = wrc_normal (distance, steps, varargin)
% WRC_NORMAL  Pressures between elastic half-spaces under a gap of your own.
%
%   r = wrc_normal (distance, steps, key, value, ...)
%
%   distance  undeformed distance at the element centres, mm; columns go along x
%   steps     sides of an element along x and y, mm
%
%   Keys: 'normal_load' (N) or 'approach' (mm); 'combined_modulus' (MPa, steel on steel by default),
%   'tolerance', 'maximum_iterations', 'solver', 'elements', 'precision' as in wrcontact_grid.h.
%
%   r.pressure (MPa), r.displacement (mm), r.approach, r.normal_force, r.area, r.pmax, ...,
%   r.load_balance, r.least_gap and r.complementarity (residuals of the solution), stop_reason,
%   r.grade, r.warnings, r.warning_classes and r.warning_grades, which are raised as by wrc_solve.
%   Errors: see wrc_solve.
%
%   Example: a sphere of 500 mm radius on a plane
%     [x, y] = ndgrid ((-15.5:15.5) / 2);
%     r = wrc_normal ((x.^2 + y.^2) / 1000, [0.5 0.5], 'normal_load', 80000);
%
%   See also wrc_rolling, wrc_solve.
  result = wrc_mex ('normal', distance, steps, varargin{:});
end
