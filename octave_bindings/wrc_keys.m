function keys = wrc_keys (words)
% WRC_KEYS  The keys of a scene.
%
%   wrc_keys ('pose')            prints the keys whose names contain a text, '' for all
%   keys = wrc_keys ('pose')     the same as a struct array: name, default, allowed, meaning
%
%   See also wrc_solve.
  keys = wrc_mex ('keys');
  if nargin > 0
    keys = keys(~cellfun (@isempty, strfind ({keys.name}, words)));
  end
  if nargout == 0
    for k = 1:numel (keys)
      fprintf ('%s = %s\n  %s; allowed: %s\n', keys(k).name, keys(k).default, ...
               keys(k).meaning, keys(k).allowed);
    end
    clear keys
  end
end
