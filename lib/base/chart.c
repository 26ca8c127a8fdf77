/* chart.c - the kinds of charts. */
#include <stddef.h>

#include "chart.h"

const ChartKind CHART_RECTANGLE = { .joined = { { 0, 0 }, { 0, 0 } }, .beyond = NULL };
