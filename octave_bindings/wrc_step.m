function varargout = wrc_step (varargin)
% WRC_STEP  One evaluation of a wheelset in a vehicle simulation.
%
%   w = wrc_step ('open', key, value, ...)        a wheelset; arguments as for wrc_solve, and
%                                                 'planner' ('estimate' or 'measure': FFTW times
%                                                 its algorithms) and 'precision' ('mixed' or
%                                                 'double') of its solver
%   force = wrc_step (w, position, velocity)
%   [force, state, by_position, by_velocity] = wrc_step (w, position, velocity, rails)
%   r = wrc_step ('results', w)                   all results of the last step, as from wrc_solve
%   wrc_step ('close', w)
%
%   position     x, y, z, roll, pitch angle, yaw of the wheelset's centre, z above the rail tops
%   velocity     their rates; that of the pitch angle > 0 when the axle rolls forward
%   rails        displacement of the left rail (lateral, vertical, roll), then of the right one
%   force        6 x 2: of the left and the right wheel force x, y, z, moment x, y, z about the
%                centre
%   state        for each wheel: 1 lifted, 2 on the flange tip, 4 on the chamfer, 8 beyond yield,
%                32 at the end of a part of a rail that varies
%   by_position  6 x 6 x 2: derivatives of the forces, (:,k,s) by position k, of the left (s = 1)
%                and the right wheel; by_velocity likewise. They cost time only if they are asked for.
%
%   Units: mm, N, rad, s unless the scene says 'convention.units', 'SI'. Creep forces need
%   'solve.creep', for example 'fastsim'. Errors: as of wrc_solve; a step that fails changes nothing.
%   What was left open is closed by clear wrc_mex.
%
%   See also wrc_solve, and docs/vehicle.md.
  if nargin > 0 && ischar (varargin{1})
    [varargout{1:min (nargout, 1)}] = wrc_mex (varargin{:});
  else
    [varargout{1:max (nargout, 1)}] = wrc_mex ('step', varargin{:});
  end
end
