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
    plot (side.rail_y, side.rail_z, 'k-', side.wheel_y, side.wheel_z, 'b-');
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
    pressure = at.pressure;
    pressure(pressure == 0) = NaN; % not drawn
    surface (at.y, at.x, 0 * pressure - 1, pressure, 'edgecolor', 'none');
  end
  hold off
  view (2);
  axis equal
  box on
  set (gca (), 'xdir', 'reverse');
  xlabel ('y, mm');
  ylabel ('x, mm');
  title (sprintf ('%.0f MPa, %.1f kN', side.pmax, side.normal_force / 1000));
  colorbar ();
end
