% verdicts.m LHREAD FILE...: "read" or "refused" and the message for each file, one on each line.
a = argv();
addpath(fileparts(a{1}));
for k = 2:numel(a)
	try
		lhread(a{k});
		printf('read\n');
	catch e
		printf('refused %s\n', e.message);
	end
end
