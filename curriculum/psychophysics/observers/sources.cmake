list(APPEND psychophysics_sources observers/observer_spec.cpp observers/simulated_observer.cpp observers/thurstone.cpp observers/tied_orders.cpp)
