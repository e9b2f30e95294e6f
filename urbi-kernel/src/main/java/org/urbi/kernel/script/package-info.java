/** urbiscript as a scripting language of the Java platform (JSR 223). */
@NullMarked
package org.urbi.kernel.script;

import org.jspecify.annotations.NullMarked;
