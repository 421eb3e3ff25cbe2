//! Files import each other one way: none depends, over others, on one that depends on it.

use std::collections::BTreeMap;
use std::path::Path;

use petgraph::algo::tarjan_scc;
use petgraph::graphmap::DiGraphMap;
use syn::{Item, ItemUse, UseTree, Visibility};

/// A module by the names on the way to it from the root.
type Module = Vec<String>;

/// What a module names of another one: the module, and what comes after that.
struct Import {
    module: Module,
    rest: Vec<String>,
    is_handed_on: bool,
}

/// The files of a crate and what they import of each other, but for their tests.
struct Crate {
    imports: BTreeMap<Module, Vec<Import>>,
}

impl Crate {
    /// The one whose root module is `name` in the `folder`.
    fn read(folder: &Path, name: &str, without: &[&str]) -> Self {
        let mut files = BTreeMap::new();
        collect(folder, &mut vec![], without, &mut files);
        let root = files.remove(&vec![name.to_owned()]).expect("the root of the crate");
        files.insert(vec![], root);
        let modules: Vec<Module> = files.keys().cloned().collect();
        let imports = files.into_iter().map(|(own, items)| {
            let uses = items.iter().filter_map(|item| match item {
                Item::Use(item) => Some(item),
                _ => None,
            });
            let found = uses.flat_map(|item| imports_of(&own, item, &modules)).collect();
            (own, found)
        });
        Self { imports: imports.collect() }
    }

    /// The module that defines what an import names, which others may hand on.
    fn home<'a>(&'a self, import: &'a Import) -> &'a Module {
        let own = self.imports.get(&import.module).into_iter().flatten();
        let mut handed_on = own.filter(|other| other.is_handed_on);
        let name = import.rest.first();
        let found = handed_on.find(|other| {
            let last = other.rest.last().or(other.module.last());
            name.is_some() && last == name && other.module != import.module
        });
        found.map_or(&import.module, |other| self.home(other))
    }

    /// Circles of files that import each other.
    fn circles(&self) -> Vec<Vec<String>> {
        let mut graph: DiGraphMap<&Module, ()> = DiGraphMap::new();
        for (own, imports) in &self.imports {
            for import in imports {
                let home = self.home(import);
                // A module may hand on what is inside of it.
                if home != own && !(import.is_handed_on && home.starts_with(own)) {
                    graph.add_edge(own, home, ());
                }
            }
        }
        let circles = tarjan_scc(&graph).into_iter().filter(|circle| circle.len() > 1);
        circles.map(|circle| circle.iter().map(|module| module.join("::")).collect()).collect()
    }
}

/// Reads all files below a `folder`, that of the module `at`.
fn collect(
    folder: &Path,
    at: &mut Module,
    without: &[&str],
    files: &mut BTreeMap<Module, Vec<Item>>,
) {
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        if path.is_dir() {
            if !without.contains(&name.as_str()) {
                at.push(name);
                collect(&path, at, without, files);
                at.pop();
            }
            continue;
        }
        if path.extension().is_none_or(|kind| kind != "rs") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a file of Rust");
        let items = syn::parse_file(&text).expect("Rust").items;
        let mut module = at.clone();
        if name != "mod" {
            module.push(name);
        }
        files.insert(module, items);
    }
}

/// What a statement in the module `own` imports of the `modules` of its crate.
fn imports_of(own: &Module, item: &ItemUse, modules: &[Module]) -> Vec<Import> {
    let mut paths = vec![];
    flatten(&item.tree, &mut vec![], &mut paths);
    let is_handed_on = !matches!(item.vis, Visibility::Inherited);
    let absolute = paths.into_iter().filter_map(|path| {
        let ups = path.iter().take_while(|name| *name == "super").count();
        let (mut module, rest) = match path[0].as_str() {
            "crate" => (vec![], &path[1..]),
            "self" => (own.clone(), &path[1..]),
            "super" => (own[..own.len() - ups].to_vec(), &path[ups..]),
            first => {
                let inside: Module = own.iter().cloned().chain([first.to_owned()]).collect();
                modules.contains(&inside).then(|| (own.clone(), &path[..]))?
            }
        };
        let mut rest = rest.to_vec();
        while let Some(name) = rest.first() {
            let inside: Module = module.iter().chain([name]).cloned().collect();
            if !modules.contains(&inside) {
                break;
            }
            module = inside;
            rest.remove(0);
        }
        Some(Import { module, rest, is_handed_on })
    });
    absolute.collect()
}

/// All paths of a tree.
fn flatten(tree: &UseTree, before: &mut Vec<String>, paths: &mut Vec<Vec<String>>) {
    match tree {
        UseTree::Path(path) => {
            before.push(path.ident.to_string());
            flatten(&path.tree, before, paths);
            before.pop();
        }
        UseTree::Group(group) => {
            group.items.iter().for_each(|tree| flatten(tree, before, paths));
        }
        UseTree::Name(name) if name.ident == "self" => paths.push(before.clone()),
        UseTree::Name(name) => paths.push([&before[..], &[name.ident.to_string()]].concat()),
        UseTree::Rename(name) => paths.push([&before[..], &[name.ident.to_string()]].concat()),
        UseTree::Glob(_) => paths.push(before.clone()),
    }
}

#[test]
fn files_import_each_other_one_way() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let library = Crate::read(&source, "lib", &["bin"]);
    let program = Crate::read(&source.join("bin/wheelrail"), "main", &[]);
    for (name, own) in [("library", library), ("program", program)] {
        let files = own.imports.len();
        let circles = own.circles();
        assert!(files > 20, "{name}: {files} files");
        assert!(circles.is_empty(), "{name}: files that import each other: {circles:#?}");
    }
}
