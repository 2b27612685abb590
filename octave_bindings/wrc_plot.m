function wrc_plot (result, file)
% WRC_PLOT  Draws a result of wrc_solve: profiles in contact, pressures of both wheels.
%
%   wrc_plot (result)
%   wrc_plot (result, 'picture.png')     draws into a file, without a window
%
%   Top: the cross section of each wheel and its rail. Bottom: the pressures on the track's plane,
%   seen in driving direction: y grows to the left, x upwards.
%
%   See also wrc_solve.
  sides = {'left', 'right'};
  sides = sides(isfield (result, sides));
  if nargin > 1
    picture = figure ('visible', 'off');
    closing = onCleanup (@() close (picture));
  else
    picture = gcf ();
    clf (picture);
  end
  for k = 1:numel (sides)
    side = result.(sides{k});
    subplot (2, numel (sides), k, 'fontsize', 8);
    plot (side.rail_y, side.rail_z, 'color', [139 90 43] / 255); % as in the programs' pictures
    hold on
    plot (side.wheel_y, side.wheel_z, 'color', [31 78 158] / 255);
    hold off
    axis equal tight
    set (gca (), 'xdir', 'reverse');
    xlabel ('y, mm');
    ylabel ('z, mm');
    title (sprintf ('%s wheel', sides{k}));
    subplot (2, numel (sides), numel (sides) + k, 'fontsize', 8);
    draw_pressures (side);
  end
  if nargin > 1
    options = {'-r120'};
    if exist ('OCTAVE_VERSION', 'builtin') && strcmp (graphics_toolkit (), 'gnuplot') ...
       && ~isempty (regexp (file, '\.png$', 'once'))
      options = {'-dpngcairo', '-S1000,760', '-F:6'}; % needs no Ghostscript
    end
    print (picture, file, options{:});
  end
end

function draw_pressures (side)
  if ~isfield (side, 'patches')
    text (0.5, 0.5, 'no contact', 'horizontalalignment', 'center');
    axis off
    return
  end
  hold on
  for patch = side.patches
    at = patch.fields;
    if min (size (at.pressure)) > 1 && any (at.pressure(:) > 0)
      levels = max (at.pressure(:)) * linspace (0.02, 1, 33);
      contourf (at.y, at.x, at.pressure, levels, 'linestyle', 'none');
    end
  end
  hold off
  stops = [253 243 200; 252 199 90; 242 137 52; 204 61 61; 107 20 70] / 255;
  colormap (interp1 ([0 0.25 0.5 0.75 1], stops, linspace (0, 1, 64)));
  axis equal
  box on
  set (gca (), 'xdir', 'reverse');
  xlabel ('y, mm');
  ylabel ('x, mm');
  title (sprintf ('%.0f MPa, %.1f kN', side.pmax, side.normal_force / 1000));
  colorbar ();
end
