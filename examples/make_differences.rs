use wheelrail::tangential::tables::CreepForceTable;
use wheelrail::tangential::coupled_marches::differences;
fn main(){ let t=std::time::Instant::now(); let n=differences::nodes(&CreepForceTable::committed_nodes().unwrap()); eprintln!("{:?}",t.elapsed());
 std::fs::write("src/tangential/coupled_marches/differences.table", n.to_bytes("Creep forces of Hertzian ellipses less those of their marches, for tangential.model = marches.\nMade by: wheelrail tables --marches -o differences.table, version 0.1.0, not given.\nNodes and error estimates are those of creep_forces.table, from which this is made.\nWhat stands where: src/tangential/tables/nodes.rs. Binary from the empty line on.")).unwrap(); }
