//! Times of one factorisation and one solution of a chain's Newton matrix, to be compared between
//! lengths: `cargo bench -p flexure-solver --bench linear_speed`.

use std::time::Instant;

use flexure_solver::Pattern;
use flexure_solver::linear::NewtonMatrix;

fn main() {
    for n in [10usize, 100, 1000, 10_000] {
        let pairs = (1..n).flat_map(|i| [(i - 1, i), (i, i - 1)]).collect();
        let pattern = Pattern { sizes: vec![6; n], velocity_blocks: n, pairs };
        let start = Instant::now();
        let mut matrix = NewtonMatrix::new(&pattern);
        let analysis = start.elapsed();
        for block in 0..n {
            let values: Vec<f64> =
                (0..36).map(|i| ((i * 37 + block) % 17) as f64 * 0.05 + if i % 7 == 0 { 8.0 } else { 0.0 }).collect();
            matrix.add(block, block, &values);
            if block > 0 {
                matrix.add(block, block - 1, &values[..36].iter().map(|v| -0.3 * v).collect::<Vec<_>>());
                matrix.add(block - 1, block, &values[..36].iter().map(|v| -0.4 * v).collect::<Vec<_>>());
            }
        }
        let repeats = (200_000 / n).max(20);
        let mut x: Vec<f64> = (0..6 * n).map(|i| (i % 13) as f64).collect();
        let mut best = [f64::INFINITY; 2];
        for _ in 0..repeats {
            let start = Instant::now();
            if matrix.factor().is_err() {
                println!("singular");
            }
            best[0] = best[0].min(start.elapsed().as_secs_f64());
            let start = Instant::now();
            matrix.solve(&mut x);
            best[1] = best[1].min(start.elapsed().as_secs_f64());
        }
        println!(
            "N = {n:6}  analysis {:8.3} ms   factor {:8.4} ms   solve {:8.4} ms",
            analysis.as_secs_f64() * 1e3,
            best[0] * 1e3,
            best[1] * 1e3
        );
    }
}
