/** Modules in processes of their own: how these are started, watched, and what is told of them. */
@NullMarked
package org.urbi.server.isolated;

import org.jspecify.annotations.NullMarked;
