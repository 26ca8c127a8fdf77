function grids = lhread(path)
% LHREAD  Read a .lhg stream in Octave or MATLAB.  MIT license, copyright 2026 the lhgrid authors.
%
%     g = lhread('face.lhg');                  % a struct array, an element for each grid
%     H = g(1).channels(strcmp({g(1).channels.name}, 'H')).data;
%     imagesc(H'); axis xy                     % H(i,j) at u = (i-1)/(nu-1), v = (j-1) T/(nv-1)
%
% Each grid has chart ('rectangle', 'sock', 'pillow'), nu, nv, T, frame, frames; channels, a struct array of name,
% unit, support, step, data;
% meta, a cell {key, value} for each datum; and history, a cell of lines.  data is nu x nv for support
% 'grid', else a column, row of nodes after row.  Whatever is wrong is an error of one line.  Written from
% format/LHG.md, whose sections are cited; every CRC is checked.  Needs no toolbox and no package.

fid = fopen(path, 'r');
if fid < 0
	error('lhread: %s: cannot be opened', path);
end
bytes = fread(fid, Inf, '*uint8');
fclose(fid);
if isempty(bytes)
	error('lhread: empty input');
end
table = crc_table();
grids = struct([]);
before = struct('frame', 0, 'frames', 0, 'crc', uint32(0));
at = 0;
while at < numel(bytes) || before.frame < before.frames
	[g, crc, at] = read_grid(bytes, at, before, table);
	before = struct('frame', g.frame, 'frames', g.frames, 'crc', crc);
	if isempty(grids)
		grids = g;
	else
		grids(end+1) = g;
	end
end
end

% ---- CRC-32 ----

function table = crc_table()
table = uint32(0:255);
for k = 1:8
	odd = bitand(table, uint32(1)) ~= 0;
	table = bitshift(table, -1);
	table(odd) = bitxor(table(odd), uint32(3988292384));            % EDB88320
end
end

% One byte for each of several CRCs at once.
function s = crc_step(s, byte, table)
k = double(bitand(bitxor(s, byte), uint32(255))) + 1;
s = bitxor(bitshift(s, -8), table(k));
end

% crc32(c, bytes).  The bytes are cut into lanes of equal length whose CRCs are computed side by side; 32
% more lanes of zeros, one for each bit, say how a CRC changes by that many zero bytes.
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

% ---- one grid: sections 2 to 5 ----

function part = take(bytes, at, n, what)
if at + n > numel(bytes)
	error('lhread: input ends in %s', what);
end
part = bytes(at+1:at+n);
end

function [g, crc, at] = read_grid(bytes, at, before, table)
[g, named, crc, len] = read_head(bytes, at, table);
inside = before.frame < before.frames;
if (inside && (g.frame ~= before.frame + 1 || g.frames ~= before.frames)) || (~inside && g.frame ~= 1)
	error('lhread: frame %d of %d comes after frame %d of %d', g.frame, g.frames, before.frame, before.frames);
end
due = uint32(0);
if inside
	due = before.crc;
end
if ~strcmp(named, sprintf('%08x', due))
	error('lhread: frame %d is of another stream', g.frame);
end
at = at + len;
for k = 1:numel(g.channels)
	[g.channels(k).data, crc, at] = read_channel(bytes, at, g, g.channels(k), crc, table);
end
mark = uint8([10, double('lhg end'), 137, 13, 10, 26, 10, zeros(1, 50), 10]');
if any(take(bytes, at, 64, 'the end mark') ~= mark)
	error('lhread: wrong end mark');
end
at = at + 64;
end

% The block of a channel, section 3.
function [data, crc, at] = read_channel(bytes, at, g, c, crc, table)
what = ['channel ' c.name];
n = samples_of(g, c);
block = 64*ceil((8*n + 4)/64);
raw = take(bytes, at, block, what);
crc = crc_of(crc, raw(1:8*n), table);
if any(raw(8*n+1:8*n+4) ~= uint8(bitand(bitshift(crc, [0 -8 -16 -24]'), uint32(255))))
	error('lhread: %s: CRC is wrong', what);
end
if any(raw(8*n+5:end) ~= 0)
	error('lhread: %s: padding is not zero', what);
end
data = typecast(raw(1:8*n), 'double');
[machine, most, order] = computer(); %#ok<ASGLU>
if order == 'B'
	data = swapbytes(data);
end
if ~all(isfinite(data))
	error('lhread: %s: a sample is not finite', what);
end
if strcmp(c.support, 'grid')
	data = reshape(data, g.nu, g.nv);
end
at = at + block;
end

% The number of samples of a support, section 2.2.
function n = samples_of(g, c)
switch c.support
case 'grid'
	n = g.nu*g.nv;
case 'border'
	if strcmp(g.chart, 'sock')
		n = g.nu*min(c.step, g.nv);
		return
	end
	n = g.nu*g.nv - max(g.nu - 2*c.step, 0)*max(g.nv - 2*c.step, 0);
otherwise
	n = (floor((g.nu - 1)/c.step) + 1)*(floor((g.nv - 1)/c.step) + 1);
end
end

% ---- the header, section 2 ----

function [g, named, crc, len] = read_head(bytes, at, table)
[lines, len] = split_head(bytes, at);
crc = crc_of(uint32(0), bytes(at+1:at+len-9), table);
if mod(len, 64) ~= 0 || ~strcmp(char(bytes(at+len-8:at+len-1)'), sprintf('%08x', crc))
	error('lhread: header CRC or length is wrong');
end
spaces = numel(lines{end}) - 11;
if spaces < 1 || spaces > 64 || isempty(regexp(lines{end}, '^end +[0-9a-f]{8}$', 'once'))
	error('lhread: header has a wrong end');
end
lines(end) = [];
count = '(0|[1-9][0-9]{0,9})';
version = need(lines, 1, 'lhg ([12])');
size = str2double(need(lines, 2, ['size ' count ' ' count]));
T = need(lines, 3, 'height ([0-9.e+-]{1,39})');
frame = need(lines, 4, ['frame ' count ' ' count ' ([0-9a-f]{8})']);
named = frame{3};
k = 5;
chart = {'rectangle'};
if version{1} == '2'
	chart = need(lines, k, 'chart (sock|pillow)');
	k = k + 1;
end
g = struct('chart', chart{1}, 'nu', size(1), 'nv', size(2), 'T', height_of(T{1}), ...
    'frame', str2double(frame{1}), ...
    'frames', str2double(frame{2}), 'channels', [], 'meta', {cell(0, 2)}, 'history', {cell(0, 1)});
if any(size < 2 | size > 32768) || g.frame < 1 || g.frame > g.frames || g.frames > 1000000
	error('lhread: size or frame is out of range');
end
if ~strcmp(g.chart, 'rectangle') && mod(g.nu, 2) == 1
	error('lhread: a %s has an even number of nodes along u', g.chart);
end
[g.channels, k] = read_channels(lines, k, max(size), count);
if ~strcmp(g.chart, 'rectangle') && any(strcmp({g.channels.support}, 'lattice'))
	error('lhread: a %s has no lattice', g.chart);
end
if strcmp(g.chart, 'pillow') && any(strcmp({g.channels.support}, 'border'))
	error('lhread: a pillow has no border');
end
text = '([^ ]|[^ ].*[^ ])';
while ~isempty(parts(lines, k, ['meta ([A-Za-z0-9._+-]{1,63}) ' text]))
	m = parts(lines, k, ['meta ([A-Za-z0-9._+-]{1,63}) ' text]);
	if any(strcmp(g.meta(:,1), m{1}))
		error('lhread: metadatum %s is there twice', m{1});
	end
	g.meta(end+1,:) = {m{1}, unicode(m{2})};
	k = k + 1;
end
while ~isempty(parts(lines, k, ['history ' text]))
	m = parts(lines, k, ['history ' text]);
	g.history{end+1,1} = unicode(m{1});
	k = k + 1;
end
if k <= numel(lines)
	error('lhread: header line %d is malformed', k);
end
end

function [channels, k] = read_channels(lines, k, nodes, count)
channels = struct('name', {}, 'unit', {}, 'support', {}, 'step', {}, 'data', {});
start = 'channel ([A-Za-z0-9._+-]{1,31}) ([A-Za-z0-9._+/^*-]{1,31}) ';
while true
	m = parts(lines, k, [start '(grid)']);
	if isempty(m)
		m = parts(lines, k, [start '(border|lattice) ' count]);
	else
		m{4} = '0';
	end
	if isempty(m)
		break
	end
	step = str2double(m{4});
	if any(strcmp({channels.name}, m{1})) || (~strcmp(m{3}, 'grid') && (step < 1 || step > nodes - 1))
		error('lhread: channel %s is there twice, or its step does not suit the grid', m{1});
	end
	channels(end+1) = struct('name', m{1}, 'unit', m{2}, 'support', m{3}, 'step', step, 'data', []); %#ok<AGROW>
	k = k + 1;
end
if numel(channels) < 1 || numel(channels) > 64
	error('lhread: number of channels is not 1 to 64');
end
end

% The lines of the header that begins behind byte `at`, without LF, and its length in bytes.
function [lines, len] = split_head(bytes, at)
first = char(take(bytes, at, 6, 'line 1')');
if ~any(strcmp(first, {['lhg 1' char(10)], ['lhg 2' char(10)]}))
	if at == 0
		error('lhread: input is not an lhg stream, or of another version');
	end
	error('lhread: bytes follow the end mark');
end
head = bytes(at+1:min(at + 65536, numel(bytes)));
ends = find(head == 10);
starts = [1; ends(1:end-1) + 1];
lines = {};
for k = 1:numel(ends)
	lines{k} = checked(head(starts(k):ends(k)-1)'); %#ok<AGROW>
	if strncmp(lines{k}, 'end', 3)
		len = ends(k);
		return
	end
end
error('lhread: header has no end');
end

% A line as text: UTF-8 without control characters, section 2.3.
function text = checked(line)
b = double(line);
if numel(b) > 4000 || any(b < 32 | b == 127)
	error('lhread: a header line is too long or has control characters');
end
k = 1;
while k <= numel(b)
	more = (b(k) >= 194) + (b(k) >= 224) + (b(k) >= 240);
	good = b(k) < 128 || (b(k) >= 194 && b(k) <= 244 && k + more <= numel(b));
	good = good && all(b(k+1:k+more) >= 128 & b(k+1:k+more) < 192);
	if good && more > 0                     % overlong, surrogate, beyond U+10FFFF, U+0080 to U+009F
		next = b(k+1);
		good = ~((b(k) == 224 && next < 160) || (b(k) == 237 && next > 159) || (b(k) == 240 && next < 144) || ...
		    (b(k) == 244 && next > 143) || (b(k) == 194 && next < 160));
	end
	if ~good
		error('lhread: a header line is not UTF-8 or has control characters');
	end
	k = k + 1 + more;
end
text = char(line);
end

% The parts of line k by a pattern, {} if it does not match or is not there.
function m = parts(lines, k, pattern)
m = {};
if k <= numel(lines)
	m = regexp(lines{k}, ['^' pattern '$'], 'tokens', 'once');
end
end

function m = need(lines, k, pattern)
m = parts(lines, k, pattern);
if isempty(m)
	error('lhread: header line %d is malformed', k);
end
end

% Octave's strings are UTF-8; those of MATLAB are not.
function text = unicode(text)
if ~exist('OCTAVE_VERSION', 'builtin')
	text = native2unicode(uint8(text), 'UTF-8');
end
end

% The height of line 3: in its only spelling, positive and finite.
function T = height_of(text)
T = str2double(text);
if ~(T > 0) || ~isfinite(T)
	error('lhread: height is not a positive number');
end
for digits = 15:17
	spelt = sprintf('%.*g', digits, T);
	if str2double(spelt) == T
		break
	end
end
if ~strcmp(spelt, text)
	error('lhread: height is not in its only spelling');
end
end
