function lhwrite(path, grids)
% LHWRITE  Write a .lhg stream in Octave or MATLAB.  MIT license, copyright 2026 the lhgrid authors.
%
%     g = lhread('face.lhg');
%     k = strcmp({g.channels.name}, 'H');
%     g.channels(k).data = 0.5*g.channels(k).data;
%     g.history{end+1} = '# H halved';         % what was done, for whoever reads the file
%     lhwrite('half.lhg', g)
%
% grids is a struct array as lhread returns it; the fields chart ('rectangle'), frame and frames (1, 2, ..
% of their number), meta and history may be missing.  Equal grids give equal bytes.  What lhread, which must
% be in the path, would refuse is an error of one line; path then is as it was.  Written from
% format/LHG.md, whose sections are cited.

if ~isstruct(grids) || isempty(grids) || ~all(isfield(grids, {'nu', 'nv', 'T', 'channels'}))
	error('lhwrite: need a struct array with the fields of lhread');
end
grids = completed(grids);
folder = fileparts(path);
if isempty(folder)
	folder = '.';
end
scratch = tempname(folder);             % renamed when it is complete
fid = fopen(scratch, 'w');
if fid < 0
	error('lhwrite: %s: cannot be written', path);
end
try
	write_grids(fid, grids, path);
	fid = close_or_die(fid, path);
	check_again(scratch, grids);
	[done, why] = rename_file(scratch, path);
	if ~done
		error('lhwrite: %s: %s', path, why);
	end
catch err
	if fid >= 0
		fclose(fid);
	end
	if exist(scratch, 'file')
		delete(scratch);
	end
	error('%s', strrep(err.message, 'lhread: ', 'lhwrite: '));
end
end

% The grids with the fields that may be missing.
function grids = completed(grids)
n = numel(grids);
for k = 1:n
	if ~isfield(grids, 'chart') || isempty(grids(k).chart),   grids(k).chart = 'rectangle'; end
	if ~isfield(grids, 'frame') || isempty(grids(k).frame),   grids(k).frame = k; end
	if ~isfield(grids, 'frames') || isempty(grids(k).frames), grids(k).frames = n; end
	if ~isfield(grids, 'meta') || isempty(grids(k).meta),     grids(k).meta = cell(0, 2); end
	if ~isfield(grids, 'history') || isempty(grids(k).history), grids(k).history = cell(0, 1); end
	grids(k).history = grids(k).history(:);
end
end

function write_grids(fid, grids, path)
table = crc_table();
crc = uint32(0);
for k = 1:numel(grids)
	g = grids(k);
	if g.frame == 1
		crc = uint32(0);
	end
	[head, crc] = head_of(g, crc, table);
	put(fid, head, path);
	for c = g.channels(:)'
		[block, crc] = block_of(g, c, crc, table);
		put(fid, block, path);
	end
	put(fid, uint8([10, double('lhg end'), 137, 13, 10, 26, 10, zeros(1, 50), 10]'), path);
end
end

function put(fid, bytes, path)
if fwrite(fid, bytes, 'uint8') ~= numel(bytes)
	error('lhwrite: %s: cannot be written', path);
end
end

function fid = close_or_die(fid, path)
failed = fclose(fid) ~= 0;
fid = -1;
if failed
	error('lhwrite: %s: cannot be written', path);
end
end

% The header, section 2, and the CRC that ends it.
function [head, crc] = head_of(g, due, table)
plain = strcmp(g.chart, 'rectangle');
lines = {sprintf('lhg %d', 2 - plain), sprintf('size %d %d', g.nu, g.nv), ['height ' spelling(g.T)], ...
    sprintf('frame %d %d %08x', g.frame, g.frames, due)};
if ~plain
	lines{end+1} = ['chart ' g.chart];
end
for c = g.channels(:)'
	step = '';
	if ~strcmp(c.support, 'grid')
		step = sprintf(' %d', c.step);
	end
	lines{end+1} = ['channel ' c.name ' ' c.unit ' ' c.support step]; %#ok<AGROW>
end
for k = 1:size(g.meta, 1)
	lines{end+1} = ['meta ' g.meta{k,1} ' ' g.meta{k,2}]; %#ok<AGROW>
end
for k = 1:numel(g.history)
	lines{end+1} = ['history ' g.history{k}]; %#ok<AGROW>
end
head = [utf8(sprintf('%s\n', lines{:})), uint8('end')];
head = [head, repmat(uint8(' '), 1, 64 - mod(numel(head) + 9, 64))];
crc = crc_of(uint32(0), head', table);
head = [head, uint8(sprintf('%08x\n', crc))]';
end

% The block of a channel, section 3, and the CRC after it.
function [block, crc] = block_of(g, c, crc, table)
what = ['lhwrite: channel ' c.name];
if ~isnumeric(c.data) || ~isreal(c.data)
	error('%s is not of real numbers', what);
end
if strcmp(c.support, 'grid')
	fits = isequal(size(c.data), [g.nu g.nv]);
else
	fits = size(c.data, 2) == 1;    % check_again finds a wrong number of samples
end
if ~fits
	error('%s: the shape of the data is not that of its support', what);
end
data = double(c.data(:));
[machine, most, order] = computer(); %#ok<ASGLU>
if order == 'B'
	data = swapbytes(data);
end
raw = typecast(data, 'uint8');
raw = raw(:);
crc = crc_of(crc, raw, table);
tail = uint8(bitand(bitshift(crc, [0 -8 -16 -24]'), uint32(255)));
block = [raw; tail; zeros(mod(-numel(raw) - 4, 64), 1, 'uint8')];
end

% Reads the file that was written: it must be a stream, and hold these grids.
function check_again(scratch, grids)
again = lhread(scratch);
same = numel(again) == numel(grids);
for k = 1:numel(again)
	same = same && isequal({again(k).channels.name}, {grids(k).channels.name}) && ...
	    isequal(again(k).meta, grids(k).meta) && isequal(again(k).history, grids(k).history);
end
if ~same
	error('lhwrite: a line break in a name or text, or fields of another kind');
end
end

% T in its only spelling, section 2.
function text = spelling(T)
for digits = 15:17
	text = sprintf('%.*g', digits, T);
	if str2double(text) == T
		return
	end
end
end

function bytes = utf8(text)
if exist('OCTAVE_VERSION', 'builtin')
	bytes = uint8(text);            % Octave's strings are UTF-8
else
	bytes = unicode2native(text, 'UTF-8');
end
end

function [done, why] = rename_file(from, to)
if exist('OCTAVE_VERSION', 'builtin')
	[err, why] = rename(from, to);
	done = err == 0;
else
	[done, why] = movefile(from, to, 'f');
end
end

% ---- CRC-32, as in lhread.m, where it is explained ----

function table = crc_table()
table = uint32(0:255);
for k = 1:8
	odd = bitand(table, uint32(1)) ~= 0;
	table = bitshift(table, -1);
	table(odd) = bitxor(table(odd), uint32(3988292384));            % EDB88320
end
end

function s = crc_step(s, byte, table)
k = double(bitand(bitxor(s, byte), uint32(255))) + 1;
s = bitxor(bitshift(s, -8), table(k));
end

function crc = crc_of(crc, bytes, table)
n = numel(bytes);
lanes = max(1, floor(sqrt(n/4)));
len = floor(n/lanes);
part = [reshape(uint32(bytes(1:lanes*len)), len, lanes), zeros(len, 32, 'uint32')];
ones32 = uint32(4294967295);
bits = bitshift(uint32(1), 0:31);
s = [bitxor(crc, ones32), zeros(1, lanes - 1, 'uint32'), bits];
for k = 1:len
	s = crc_step(s, part(k,:), table);
end
now = s(1);
for lane = 2:lanes
	on = lanes + find(bitand(now, bits) ~= 0);
	now = s(lane);
	for k = on
		now = bitxor(now, s(k));
	end
end
for k = lanes*len+1:n
	now = crc_step(now, uint32(bytes(k)), table);
end
crc = bitxor(now, ones32);
end
