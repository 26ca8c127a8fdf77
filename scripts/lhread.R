# lhread.R - read .lhg streams in R.  MIT license, copyright 2026 the lhgrid authors.
#
#     source("lhread.R")
#     g <- lhread("face.lhg")[[1]]             # one list for each grid of the stream
#     image(g$channels$H$data)                 # data[i, j] at u = (i-1)/(nu-1), v = (j-1) T/(nv-1)
#
# Each grid is a list of chart ("rectangle", "sock", "pillow"), nu, nv, T, frame, frames, channels (by name: unit,
# support, step, data), meta (a named vector) and history.  data is a matrix nu x nv for support "grid",
# else a vector, row after row.  Whatever is wrong stops with one line.  Written from format/LHG.md, whose sections are cited;
# every CRC is checked.  Needs no package.

lhread <- function(path) {
	bytes <- readBin(path, "raw", file.info(path)$size)
	if (length(bytes) == 0)
		lhg_stop("empty input")
	grids <- list()
	order <- list(frame = 0, frames = 0, crc = "00000000")
	at <- 0
	while (at < length(bytes) || order$frame < order$frames) {
		got <- lhg_grid(bytes, at, order)
		grids <- c(grids, list(got$grid))
		order <- list(frame = got$grid$frame, frames = got$grid$frames, crc = lhg_hex(got$crc))
		at <- got$at
	}
	grids
}

lhg_stop <- function(...) stop(paste0("lhread: ", ...), call. = FALSE)

# ---- CRC-32, as two numbers of 16 bits each (high, low), since R has no unsigned integers ----

lhg_table <- local({
	high <- integer(256)
	low <- 0:255
	for (k in 1:8) {
		odd <- low %% 2L
		low <- bitwXor(low %/% 2L + (high %% 2L)*32768L, odd*0x8320L)
		high <- bitwXor(high %/% 2L, odd*0xEDB8L)
	}
	list(high = high, low = low)
})

# One byte for each of several CRCs at once.
lhg_step <- function(s, byte) {
	k <- bitwXor(s$low %% 256L, byte) + 1L
	list(high = bitwXor(s$high %/% 256L, lhg_table$high[k]),
	    low = bitwXor(s$low %/% 256L + (s$high %% 256L)*256L, lhg_table$low[k]))
}

# crc32(c, bytes).  The bytes are cut into lanes of equal length whose CRCs are computed side by side; 32
# more lanes of zeros, one for each bit, say how a CRC changes by that many zero bytes.
lhg_crc <- function(crc, bytes) {
	n <- length(bytes)
	lanes <- max(1, floor(sqrt(n/4)))
	len <- n %/% lanes
	value <- as.integer(bytes)
	bit <- as.integer(2^(0:15))
	s <- list(high = c(integer(lanes), integer(16), bit), low = c(integer(lanes), bit, integer(16)))
	s$high[1] <- 65535L - crc$high
	s$low[1] <- 65535L - crc$low
	first <- (seq_len(lanes) - 1)*len
	for (k in seq_len(len))
		s <- lhg_step(s, c(value[first + k], integer(32)))
	now <- list(high = s$high[1], low = s$low[1])
	for (lane in seq_len(lanes)[-1]) {
		on <- lanes + which(c(bitwAnd(now$low, bit), bitwAnd(now$high, bit)) != 0)
		now <- list(high = Reduce(bitwXor, s$high[on], s$high[lane]),
		    low = Reduce(bitwXor, s$low[on], s$low[lane]))
	}
	for (k in seq_len(n - lanes*len) + lanes*len)
		now <- lhg_step(now, value[k])
	list(high = 65535L - now$high, low = 65535L - now$low)
}

lhg_hex <- function(crc) sprintf("%04x%04x", crc$high, crc$low)

# ---- one grid: sections 2 to 4 ----

lhg_take <- function(bytes, at, n, what) {
	if (at + n > length(bytes))
		lhg_stop("input ends in ", what)
	bytes[at + seq_len(n)]
}

lhg_grid <- function(bytes, at, order) {
	head <- lhg_head(bytes, at)
	g <- head$grid
	inside <- order$frame < order$frames
	if (g$frame != (if (inside) order$frame + 1 else 1) || (inside && g$frames != order$frames))
		lhg_stop("frame ", g$frame, " of ", g$frames, " comes after frame ", order$frame, " of ", order$frames)
	if (head$before != (if (inside) order$crc else "00000000"))
		lhg_stop("frame ", g$frame, " is of another stream")
	at <- at + head$length
	crc <- head$crc
	for (name in names(g$channels)) {
		c <- g$channels[[name]]
		n <- lhg_count(g, c$support, c$step)
		samples <- lhg_take(bytes, at, 8*n, paste("channel", name))
		crc <- lhg_crc(crc, samples)
		rest <- lhg_take(bytes, at + 8*n, 64 - (8*n) %% 64, paste("channel", name))
		want <- c(crc$low %% 256, crc$low %/% 256, crc$high %% 256, crc$high %/% 256)
		if (any(as.integer(rest[1:4]) != want))
			lhg_stop("channel ", name, ": CRC is wrong")
		if (any(rest[-(1:4)] != 0))
			lhg_stop("channel ", name, ": padding is not zero")
		data <- readBin(samples, "double", n, endian = "little")
		if (!all(is.finite(data)))
			lhg_stop("channel ", name, ": a sample is not finite")
		g$channels[[name]]$data <- if (c$support == "grid") matrix(data, g$nu, g$nv) else data
		at <- at + 8*n + length(rest)
	}
	mark <- as.raw(c(10, utf8ToInt("lhg end"), 0x89, 13, 10, 26, 10, rep(0, 50), 10))
	if (any(lhg_take(bytes, at, 64, "the end mark") != mark))
		lhg_stop("wrong end mark")
	list(grid = g, crc = crc, at = at + 64)
}

lhg_count <- function(g, support, step) {
	if (support == "grid")
		g$nu*g$nv
	else if (g$chart == "sock")
		g$nu*min(step, g$nv)
	else if (support == "border")
		g$nu*g$nv - max(g$nu - 2*step, 0)*max(g$nv - 2*step, 0)
	else
		((g$nu - 1) %/% step + 1)*((g$nv - 1) %/% step + 1)
}

# The lines of the header that begins at `at`, as raw vectors without LF, and its length in bytes.
lhg_lines <- function(bytes, at) {
	first <- lhg_take(bytes, at, 6, "line 1")
	if (!identical(first, charToRaw("lhg 1\n")) && !identical(first, charToRaw("lhg 2\n")))
		lhg_stop(if (at == 0) "input is not an lhg stream, or of another version" else "bytes follow the end mark")
	part <- bytes[at + seq_len(min(65536, length(bytes) - at))]
	ends <- which(part == 10)
	starts <- c(1, ends + 1)[seq_along(ends)]
	last <- which(part[starts] == 0x65 & part[starts + 1] == 0x6e & part[starts + 2] == 0x64)
	if (length(last) == 0)
		lhg_stop("header has no end")
	k <- seq_len(last[1])
	list(lines = Map(function(a, b) part[seq(a, length.out = b - a)], starts[k], ends[k]),
	    length = ends[last[1]], bytes = part[seq_len(ends[last[1]])])
}

# A line as text, or a stop: section 2.3 allows UTF-8 without control characters.
lhg_text <- function(line) {
	value <- as.integer(line)
	n <- length(value)
	if (n > 4000 || any(value < 32 | value == 127))
		lhg_stop("a header line is too long or has control characters")
	text <- rawToChar(line)
	c1 <- n > 1 && any(value[-n] == 0xC2 & value[-1] >= 0x80 & value[-1] < 0xA0)
	if (c1 || !validUTF8(text))
		lhg_stop("a header line is not UTF-8 or has control characters")
	Encoding(text) <- "UTF-8"
	text
}

lhg_number <- "(0|[1-9][0-9]{0,9})"

lhg_head <- function(bytes, at) {
	h <- lhg_lines(bytes, at)
	n <- h$length
	crc <- lhg_crc(list(high = 0L, low = 0L), h$bytes[seq_len(n - 9)])
	if (n < 64 || n %% 64 != 0 || rawToChar(h$bytes[n - 8:1]) != lhg_hex(crc))
		lhg_stop("header CRC or length is wrong")
	lines <- vapply(h$lines, lhg_text, "")
	spaces <- nchar(lines[length(lines)], "bytes") - 11
	if (spaces < 1 || spaces > 64 || !grepl("^end +[0-9a-f]{8}$", lines[length(lines)]))
		lhg_stop("header has a wrong end")
	k <- 1
	# The parts of line k by a pattern, or NULL; a line that matches is passed.
	match <- function(pattern) {
		if (k == length(lines))
			return(NULL)
		at <- regexec(paste0("^", pattern, "$"), lines[k], useBytes = TRUE)
		m <- regmatches(lines[k], at)[[1]]
		if (length(m) == 0)
			return(NULL)
		k <<- k + 1
		m[-1]
	}
	need <- function(pattern) {
		m <- match(pattern)
		if (is.null(m))
			lhg_stop("header line ", k, " is malformed")
		m
	}
	version <- need("lhg ([12])")
	size <- as.numeric(need(paste("size", lhg_number, lhg_number)))
	T <- lhg_height(need("height ([0-9.e+-]{1,39})"))
	frame <- need(paste("frame", lhg_number, lhg_number, "([0-9a-f]{8})"))
	chart <- if (version == "2") need("chart (sock|pillow)") else "rectangle"
	g <- list(chart = chart, nu = size[1], nv = size[2], T = T,
	    frame = as.numeric(frame[1]), frames = as.numeric(frame[2]),
	    channels = list(), meta = character(), history = character())
	if (any(size < 2 | size > 32768) || g$frame < 1 || g$frame > g$frames || g$frames > 1e6)
		lhg_stop("size or frame is out of range")
	if (chart != "rectangle" && size[1] %% 2 == 1)
		lhg_stop("a ", chart, " has an even number of nodes along u")
	channel <- paste0("channel ([A-Za-z0-9._+-]{1,31}) ([A-Za-z0-9._+/^*-]{1,31}) ",
	    "(grid|(border|lattice) ", lhg_number, ")")
	while (!is.null(m <- match(channel))) {
		step <- if (m[3] == "grid") 0 else as.numeric(m[5])
		if (m[1] %in% names(g$channels) || (m[3] != "grid" && (step < 1 || step > max(size) - 1)))
			lhg_stop("channel ", m[1], " is there twice, or its step does not suit the grid")
		support <- if (m[3] == "grid") "grid" else m[4]
		if ((support == "lattice" && chart != "rectangle") || (support == "border" && chart == "pillow"))
			lhg_stop("channel ", m[1], ": a ", chart, " has no ", support)
		g$channels[[m[1]]] <- list(unit = m[2], support = support, step = step, data = NULL)
	}
	if (length(g$channels) < 1 || length(g$channels) > 64)
		lhg_stop("number of channels is not 1 to 64")
	text <- "([^ ]|[^ ].*[^ ])"
	while (!is.null(m <- match(paste("meta ([A-Za-z0-9._+-]{1,63})", text)))) {
		if (m[1] %in% names(g$meta))
			lhg_stop("metadatum ", m[1], " is there twice")
		Encoding(m) <- "UTF-8"
		g$meta[m[1]] <- m[2]
	}
	while (!is.null(m <- match(paste("history", text)))) {
		Encoding(m) <- "UTF-8"
		g$history <- c(g$history, m[1])
	}
	if (k != length(lines))
		lhg_stop("header line ", k, " is malformed")
	list(grid = g, before = frame[3], crc = crc, length = n)
}

# The height of line 3, section 2: in its only spelling, positive and finite.  as.numeric may be off by
# a bit, so its neighbours are tried, too.
lhg_height <- function(text) {
	T <- suppressWarnings(as.numeric(text))
	if (is.na(T) || !(T > 0) || !is.finite(T))
		lhg_stop("height is not a positive number")
	bit <- max(2^(floor(log2(T)) - 52), 2^-1074)
	for (x in T + bit*c(0, 1, -1))
		for (digits in 15:17) {
			spelt <- sprintf("%.*g", digits, x)
			if (spelt == text)
				return(x)
			if (as.numeric(spelt) == x)
				break                   # fewer digits were enough: this is the only spelling of x
		}
	lhg_stop("height is not in its only spelling")
}
