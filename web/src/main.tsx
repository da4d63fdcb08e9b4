import { render } from "preact";
import { App } from "./parts/App";
import * as route from "./route";
import { begin } from "./store";
import { language, speak } from "./texts";
import * as theme from "./theme";
import "./style.css";

theme.begin();
speak(language.value);
route.begin();
begin();
render(<App />, document.getElementById("page") as HTMLElement);
