% dump.m LHREAD FILE OUT: all that lhread.m reads from FILE, as dump.py writes it.
a = argv();
addpath(fileparts(a{1}));
out = fopen(a{3}, 'w');
for g = lhread(a{2})
	fprintf(out, '%d %d %.17g %d %d\n', g.nu, g.nv, g.T, g.frame, g.frames);
	for c = g.channels
		fprintf(out, '%s %s %s %d\n', c.name, c.unit, c.support, c.step);
		fwrite(out, c.data, 'double', 0, 'ieee-le');
	end
	for k = 1:rows(g.meta)
		fprintf(out, 'meta %s %s\n', g.meta{k,:});
	end
	for k = 1:numel(g.history)
		fprintf(out, 'history %s\n', g.history{k});
	end
end
fclose(out);
