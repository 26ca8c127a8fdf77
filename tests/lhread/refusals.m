% refusals.m - for lhread.bats: refusals.m SCRIPTS FILE TO: prints what lhwrite says of grids that are no
% .lhg stream; each line begins with the name of the mistake.  FILE is a stream of one grid.
args = argv();
addpath(args{1});
good = lhread(args{2});
to = args{3};

function try_it(name, to, g)
	try
		lhwrite(to, g);
		printf('%s: written\n', name);
	catch err
		printf('%s: %s\n', name, err.message);
	end
end

g = good; g.channels(1).data(1) = NaN;            try_it('nan', to, g);
g = good; g.channels(1).data(end,:) = [];         try_it('shape', to, g);
g = good; g.channels(1).name = 'a b';             try_it('name', to, g);
g = good; g.channels(2).name = g.channels(1).name; try_it('twice', to, g);
g = good; g.history = {sprintf('one\nhistory two')}; try_it('break', to, g);
g = good; g.history = {' space'};                 try_it('space', to, g);
g = good; g.meta = {'bad key', 'x'};              try_it('key', to, g);
g = good; g.T = -1;                               try_it('height', to, g);
g = good; g.frame = 2;                            try_it('frame', to, g);
g = good; g.frames = 2;                           try_it('short', to, g);
g = good; g.channels = g.channels([]);            try_it('none', to, g);
g = good; g.channels(1).support = 'border'; g.channels(1).step = 1; g.channels(1).data = zeros(3, 1);
try_it('samples', to, g);
g = good; g.chart = 'cube';                       try_it('chart', to, g);
try_it('kind', to, 7);
try_it('folder', '/nosuch/x', good);
g = rmfield(good, {'chart', 'frame', 'frames', 'meta', 'history'});
lhwrite(to, [g g]);
again = lhread(to);
printf('defaults: %d of %d, %d meta\n', again(2).frame, again(2).frames, size(again(2).meta, 1));
