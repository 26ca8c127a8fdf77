# verdicts.R LHREAD FILE...: "read" or "refused" and the message for each file, one on each line.
a <- commandArgs(TRUE)
source(a[1])
for (file in a[-1])
	cat(tryCatch({ lhread(file); "read" }, error = function(e) paste("refused", conditionMessage(e))), "\n", sep = "")
