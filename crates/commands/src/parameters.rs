//! The parameters a command takes, as the tables of classes and verbs tell them.

use schema::{Class, Field, Group, Kind, Names, Use};

use crate::tree::{Action, ClassGroup, Parameter, Role};

/// The parameters of a command that is no macro. `attributes` are the groups `entity attributes` serves.
pub(crate) fn parameters_of(action: &Action, path: &str, attributes: &[&'static Group]) -> Vec<Parameter> {
    match action {
        Action::Set(groups) => set_parameters(path, groups),
        Action::Settings(_, group) => field_parameters(group, Use::Modify).collect(),
        Action::Create(class, group) => {
            let object = Field::new(group.object, Kind::Object(Names::New, class.id));
            let object = Parameter { name: group.object.into(), role: Role::Object, field: object };
            [object].into_iter().chain(field_parameters(group, Use::Modify)).collect()
        }
        Action::Verb(entry) => {
            let mut list: Vec<Parameter> = entry.verb.fields.iter().map(plain).collect();
            if entry.verb.path == "entity attributes" {
                for field in attributes.iter().flat_map(|g| g.fields) {
                    if !knows(&list, field.name) {
                        list.push(plain(field));
                    }
                }
            }
            list
        }
        Action::Macro(_) | Action::Unsupported => Vec::new(),
    }
}

/// Whether a command sets how objects look and whether they act, of many at once.
pub(crate) fn is_attributes(command: &str) -> bool {
    command.ends_with(" attributes")
}

fn plain(field: &Field) -> Parameter {
    Parameter { name: field.name.into(), role: Role::Field, field: *field }
}

fn knows(list: &[Parameter], name: &str) -> bool {
    list.iter().any(|p| &*p.name == name)
}

/// The parameters of a group but for those of the other form.
fn field_parameters(group: &'static Group, excluded: Use) -> impl Iterator<Item = Parameter> {
    group.fields.iter().filter(move |f| f.usage != excluded).map(plain)
}

/// The parameters of a command that sets cells of objects of several classes.
fn set_parameters(path: &str, groups: &[ClassGroup]) -> Vec<Parameter> {
    let many = is_attributes(path);
    let mut list: Vec<Parameter> = Vec::new();
    for (_, group) in groups {
        if knows(&list, group.object) {
            continue;
        }
        let classes: Vec<&Class> = groups.iter().filter(|(_, g)| g.object == group.object).map(|(c, _)| *c).collect();
        let mut field = Field::new(group.object, Kind::Object(Names::Old, common_family(&classes))).current();
        if many {
            field = field.many();
        }
        list.push(Parameter { name: group.object.into(), role: Role::Object, field });
        if groups.iter().any(|(_, g)| g.creates && g.object == group.object) {
            let field = Field::new(group.object, Kind::Object(Names::New, classes[0].id));
            list.push(Parameter { name: format!("new_{}", group.object).into(), role: Role::NewName, field });
        }
    }
    for (_, group) in groups {
        for parameter in field_parameters(group, Use::Create) {
            if !knows(&list, &parameter.name) {
                list.push(parameter);
            }
        }
    }
    list
}

/// What an object must be to belong to one of these classes.
fn common_family(classes: &[&Class]) -> &'static str {
    let Some(first) = classes.first() else { return "any" };
    if classes.iter().all(|c| c.id == first.id) {
        return first.id;
    }
    first.families.iter().copied().find(|f| classes.iter().all(|c| c.is(f))).unwrap_or("any")
}
