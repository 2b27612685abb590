% Solves the scenes of a file; Octave prints its warnings. Lines of the file: as in warnings_c.c.
warning ('off', 'backtrace');
lines = strsplit (fileread (argv (){1}), "\n");
for k = 1:numel (lines)
  [word, rest] = strtok (lines{k});
  [key, rest] = strtok (rest);
  rest = strtrim (rest);
  switch word
    case 'scene'
      name = key;
      values = {};
    case {'number', 'list'}
      values(end + 1:end + 2) = {key, sscanf(rest, '%f').'};
    case 'text'
      values(end + 1:end + 2) = {key, rest};
    case 'solve'
      fprintf (stderr, "scene %s\n", name);
      r = wrc_solve (values{:}, 'fields', '');
      [text, identifier] = lastwarn ();
      over = strcmp (r.warning_grades, 'a little over');
      last = max ([find(! over), find(over, 1)]); % of those a little over the first is told
      kinds = r.warning_classes;
      kinds(over) = {'a_little_over'};
      assert (identifier, ['wrcontact:' kinds{last}]);
      assert (text, ['wrc_mex: ' r.warnings{last}]); % Octave says which function warns
      assert (r.grade, max ([2 * any(strcmp (r.warning_grades, 'do not use')), any(over)]));
      assert (numel (r.warnings), r.warning_count);
  end
end
