function result = wrc_rolling (pressure, steps, varargin)
% WRC_ROLLING  Tractions of two bodies that roll on each other under pressures of your own.
%
%   r = wrc_rolling (pressure, steps, key, value, ...)
%
%   pressure  at the element centres, MPa, 0 outside the contact; columns go along x, the direction
%             of rolling; the origin is in the middle
%   steps     sides of an element along x and y, mm
%
%   Keys: 'longitudinal_creepage', 'lateral_creepage', 'spin_creepage' (1/mm), wheel minus rail over
%   the speed; 'friction', 'shear_modulus', 'poisson', 'tolerance', 'maximum_iterations', 'model'
%   ('full' or 'fastsim') and others as in wrcontact_grid.h.
%
%   r.traction_x, r.traction_y (MPa, on the wheel), r.slip_x, r.slip_y, r.creep_force.longitudinal,
%   r.creep_force.lateral (N), r.spin_moment (N mm), r.slip_area, r.adhesion_area, r.friction_power, ...
%   Errors: see wrc_solve.
%
%   See also wrc_normal, wrc_solve.
  result = wrc_mex ('rolling', pressure, steps, varargin{:});
end
