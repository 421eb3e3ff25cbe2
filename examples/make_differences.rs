use wheelrail::tangential::tables::CreepForceTable;
use wheelrail::tangential::coupled_marches::differences;
fn main(){ let t=std::time::Instant::now(); let n=differences::nodes(&CreepForceTable::committed_nodes().unwrap()); eprintln!("{:?}",t.elapsed());
 std::fs::write("src/tangential/coupled_marches/differences.table", n.to_bytes("x")).unwrap(); }
