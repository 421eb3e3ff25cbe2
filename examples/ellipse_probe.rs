use wheelrail::tangential::coupled_marches::ellipse::MarchedEllipse;
use wheelrail::tangential::tables::generate::ScaledEllipse;
fn main(){
  for t in [-2.5f64,-1.2,0.0,1.2,2.5] {
    println!("a/b {:.3}", t.exp());
    let e=ScaledEllipse::new(t,0.28);
    for (d,s) in [([1.0,0.0,0.0],0.02),([0.0,1.0,0.0],0.02),([0.0,0.0,1.0],0.02),([0.6,0.8,0.0],0.5),([0.0,0.6,0.8],0.5),([0.0,0.0,1.0],0.5),([0.5,0.5,0.7],0.7)] {
      let v=e.creepage(d,s);
      let fine=MarchedEllipse::with_strips(96,t,0.28).force(v);
      print!("  {d:?} {s}: {:.4?}",fine);
      let size = fine[0].hypot(fine[1]);
      for n in [8,12,16,24,48]{ let f=MarchedEllipse::with_strips(n,t,0.28).force(v); print!("  {:.4}", (f[0]-fine[0]).hypot(f[1]-fine[1])/size); }
      println!();
    }
  }
}
