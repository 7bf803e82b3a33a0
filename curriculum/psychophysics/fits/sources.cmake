list(APPEND psychophysics_sources fits/bayesian.cpp fits/beta_binomial.cpp fits/binomial_sampler.cpp fits/bootstrap.cpp
     fits/chi_square.cpp fits/derived.cpp fits/fit_curve.cpp fits/fit_priors.cpp fits/fit_summary.cpp fits/fit_warnings.cpp fits/likelihood.cpp
     fits/likelihood_search.cpp fits/limit_curves.cpp fits/maximum_likelihood.cpp fits/model_comparison.cpp fits/posterior_axes.cpp fits/density_grid.cpp
     fits/posterior_mode.cpp fits/posterior_model.cpp fits/posterior_region.cpp fits/posterior_summary.cpp
     fits/prepared_levels.cpp fits/profile_interval.cpp fits/sigmoid.cpp)
