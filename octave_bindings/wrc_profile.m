function profile = wrc_profile (name, points)
% WRC_PROFILE  A wheel or rail profile.
%
%   p = wrc_profile (name)
%   p = wrc_profile (name, points)
%
%   name    a standard profile ('S1002', '60E1'), or a file
%   points  number of points on the curve, equally spaced along its arc; 1000 by default
%
%   p.kind ('wheel' or 'rail'), p.name, p.title, p.source, p.confidence; columns p.arc, p.lateral
%   and p.height (mm; lateral > 0 to the field side, height of a wheel > 0 towards larger radius),
%   p.angle (rad), p.curvature (1/mm); p.corrections and p.warnings: corrections made to a file,
%   and what is doubtful about it. Errors: see wrc_solve.
%
%   Example:
%     p = wrc_profile ('S1002');
%     plot (p.lateral, -p.height), axis equal
%
%   See also wrc_solve.
  if nargin < 2
    points = 1000;
  end
  profile = wrc_mex ('profile', name, points);
end
