/** Variables that can be watched, and the connections between them (manual, "UVar"). */
@NullMarked
package org.urbi.kernel.variable;

import org.jspecify.annotations.NullMarked;
