% copies.m - for lhread.bats: copies.m SCRIPTS TO FILE..: each FILE is read by lhread and written to TO/NAME.
args = argv();
addpath(args{1});
for k = 3:numel(args)
	[folder, name, ext] = fileparts(args{k});
	lhwrite([args{2} '/' name ext], lhread(args{k}));
end
