# Figure by figure against what was kept (support/kept_figures.h).
chiron_test(test_kept_fits SOURCES test_kept_fits.cpp LINKS psychophysics LABELS fast unit)
chiron_test(test_kept_measures SOURCES measures/test_kept_measures.cpp LINKS psychophysics LABELS fast unit)
chiron_test(test_kept_procedures SOURCES test_kept_procedures.cpp LINKS psychophysics LABELS fast unit)
