foreach(name IN ITEMS arrangements observers_designs tied_orders procedure_simulations procedures quest_plus quest_plus_limits questplus_published staircase_published)
    chiron_test(test_${name} SOURCES test_${name}.cpp LINKS psychophysics LABELS fast unit)
endforeach()
# 100 runs of each in every run; 400 in the long one, as the README's table has them.
add_test(NAME test_procedure_simulations_400 COMMAND test_procedure_simulations)
set_tests_properties(test_procedure_simulations_400 PROPERTIES LABELS "long;unit" TIMEOUT 1800
                     ENVIRONMENT "CHIRON_SIMULATED_RUNS=400;QT_QPA_PLATFORM=offscreen")
chiron_test(test_procedure_reader SOURCES test_procedure_reader.cpp LINKS catalogue LABELS fast unit QT)
chiron_test(test_procedure_rows SOURCES test_procedure_rows.cpp LINKS catalogue LABELS fast unit QT)
