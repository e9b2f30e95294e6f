package org.urbi.kernel.library.concurrent;

import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;

/** Where implicit tags are made (manual, "Tag"). */
@UrbiType(
    value = "Tag.tags",
    protos = {"Object"},
    doc = "The tags that were made by being used.",
    needs = Permission.NOTHING)
final class TagsType {
  private TagsType() {}
}
