use mcp_core::{testing::*, *};
#[test]
fn table() {
    let problems = vec![
        siconos_2x2(1).unwrap(),
        siconos_2x2(0).unwrap(),
        siconos_tridiagonal(5, false).unwrap(),
        siconos_tridiagonal(7, true).unwrap(),
        zhuravlev_ivanov_step().unwrap(),
        kojima_shindo().unwrap(),
        josephy().unwrap(),
        watson4().unwrap(),
        nocedal_16_4().unwrap(),
        rosen_suzuki().unwrap(),
        murty(8).unwrap(),
        murty(16).unwrap(),
        murty(32).unwrap(),
        murty(64).unwrap(),
        murty(128).unwrap(),
        fathi(8).unwrap(),
        fathi(16).unwrap(),
        fathi(32).unwrap(),
        fathi(64).unwrap(),
        fathi(128).unwrap(),
        ahn(8).unwrap(),
        ahn(32).unwrap(),
        ahn(128).unwrap(),
        obstacle(10).unwrap(),
        obstacle(20).unwrap(),
        billups().unwrap(),
        log_equation().unwrap(),
        cyclic(1.0).unwrap(),
        hilbert(8).unwrap(),
    ];
    for mut p in problems {
        for start in p.starts.clone() {
            let mut line = format!("{:22} {:?}", p.name, &start[..start.len().min(4)]);
            for method in Method::ALL {
                let o = Options::new(method).with(|o| {
                    o.tol = Some(1e-10);
                    o.max_iterations = 1000;
                    o.criterion = Criterion::FbNorm;
                    o.armijo.first_step = if method == Method::OldFb { 1.0 } else { 2.0 };
                });
                let mut s = Solver::new(o).unwrap();
                let r = s.solve_from(&mut p.problem, &start).unwrap();
                line += &format!(
                    " | {}/{}/{} {} {:.1e} {:.1e}",
                    r.stats.iterations,
                    r.stats.residual_evaluations,
                    r.stats.jacobian_evaluations,
                    r.status.name(),
                    r.certificate.natural_residual,
                    r.certificate.relative_residual
                );
            }
            println!("{line}");
        }
    }
}
