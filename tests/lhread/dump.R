# dump.R LHREAD FILE OUT: all that lhread.R reads from FILE, as dump.py writes it.
a <- commandArgs(TRUE)
source(a[1])
grids <- lhread(a[2])
out <- file(a[3], "wb")
line <- function(...) writeBin(charToRaw(paste0(enc2utf8(paste(...)), "\n")), out)
for (g in grids) {
	line(g$nu, g$nv, sprintf("%.17g", g$T), g$frame, g$frames)
	for (name in names(g$channels)) {
		c <- g$channels[[name]]
		line(name, c$unit, c$support, c$step)
		writeBin(as.vector(c$data), out, endian = "little")
	}
	for (key in names(g$meta))
		line("meta", key, g$meta[key])
	for (step in g$history)
		line("history", step)
}
close(out)
